// `cls doctor --server`: does this soccer server start, and does it answer?
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "orchestration/checks/doctor/diagnosis.h"
#include "orchestration/match/options/server_choice.h"

namespace cls::orchestration::checks {

/// Starts the server for a moment, on free ports and in a folder of its own; one that runs already
/// is only talked to. It is asked as an unknown client and then as a monitor, which does not join:
/// a player's (init ...) would take a place, and give the left side its name, until the server is
/// restarted. `limit` holds for its start and its first answer.
Symptom probe_server(const match::ServerChoice& server, const std::string& own_program,
                     std::chrono::milliseconds limit, const std::atomic<int>& stop);

}  // namespace cls::orchestration::checks
