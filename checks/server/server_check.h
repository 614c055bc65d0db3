// `cls check server`: conformance check of a soccer server.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "base/result.h"
#include "checks/check_report.h"
#include "match/terms/server_choice.h"

namespace cls::checks {

struct ServerCheckOptions {
  match::ServerChoice server;    ///< embedded: `own_program server` is started
  std::string own_program;       ///< path of this binary
  std::filesystem::path folder;  ///< for the logs of a server that is started
  std::chrono::milliseconds start_timeout{20'000};
};

/// Runs all steps on a server without clients; terminates started programs. Returns an error if no
/// step could run. A nonzero `stop` skips the remaining steps.
base::Result<CheckReport> check_server(const ServerCheckOptions& options,
                                       const std::function<void(const CheckStep&)>& on_step,
                                       const std::atomic<int>& stop);

}  // namespace cls::checks
