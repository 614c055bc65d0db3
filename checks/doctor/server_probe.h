// `cls doctor --server`: whether a soccer server starts and responds.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "checks/doctor/doctor_report.h"
#include "match/terms/server_choice.h"

namespace cls::checks {

/// Starts the server briefly on free ports in a temporary folder; a running server is only
/// contacted. Connects as an unknown client, then as a monitor, never as a player: (init ...) would
/// occupy a player slot and name the left team until the server restarts. `limit` is the timeout
/// for its start and first reply.
DoctorCheck probe_server(const match::ServerChoice& server, const std::string& own_program,
                         std::chrono::milliseconds limit, const std::atomic<int>& stop);

}  // namespace cls::checks
