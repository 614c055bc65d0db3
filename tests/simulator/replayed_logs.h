// Pairs of logs, and what replaying them says.
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

/// STEM.rcg.gz and STEM.rcl.gz.
Logs read_logs(const std::filesystem::path& stem);

/// Throws where they cannot be replayed.
LogAgreement replay(const Logs& logs);

/// A line each, for messages of tests.
std::string all_misses(const LogAgreement& agreement);

}  // namespace cls::simulator
