// Reads and replays pairs of logs.
#pragma once

#include <filesystem>
#include <string>

#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "simulator/replay/log_replay.h"

namespace cls::simulator {

struct Logs {
  gamelog::MatchRecord game;
  gamelog::RclRecord text;
};

/// Reads STEM.rcg.gz and STEM.rcl.gz.
Logs read_logs(const std::filesystem::path& stem);

/// Throws if the logs cannot be replayed.
LogAgreement replay(const Logs& logs);

/// One line per miss, for failure messages.
std::string all_misses(const LogAgreement& agreement);

}  // namespace cls::simulator
