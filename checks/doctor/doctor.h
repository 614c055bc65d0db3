// `cls doctor`: checks host, programs, server and Playmaker.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "checks/doctor/doctor_report.h"
#include "match/terms/endpoint.h"
#include "match/terms/server_choice.h"

namespace cls::checks {

struct DoctorOptions {
  std::optional<match::ServerChoice> server;  ///< to check
  std::optional<match::Endpoint> playmaker;   ///< to check; not a team
  std::chrono::milliseconds limit{5'000};
  std::string own_program;  ///< path of this binary, for the embedded server
};

/// Checks host and programs, then the server and Playmaker of the options. Programs run in
/// parallel. Each program and each probe has the timeout `limit`; all processes are terminated.
/// Calls `on_check` for each item in order. A nonzero `stop` skips the remaining items.
DoctorReport examine(const DoctorOptions& options,
                     const std::function<void(const DoctorCheck&)>& on_check,
                     const std::atomic<int>& stop);

}  // namespace cls::checks
