// `cls check playmaker`: conformance check of a Playmaker.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "checks/playmaker/playmaker_subject.h"
#include "match/terms/endpoint.h"

namespace cls::checks {

struct PlaymakerCheckOptions {
  match::Endpoint endpoint;      ///< not a team
  std::filesystem::path folder;  ///< for the log of a program that is started
  Milliseconds start_timeout{20'000};
  Milliseconds deadline{3'000};
  int calls = 10'000;
  Milliseconds latency_limit{100};
  std::vector<std::string> only;  ///< steps to run; empty: all
};

/// Called after each step.
using OnStep = std::function<void(const CheckStep&)>;

/// Runs all steps; terminates started programs. If the Playmaker is unreachable, the first step
/// fails and the others are skipped. Errors: bad script, process not started. A nonzero `stop`
/// skips the remaining steps.
base::Result<CheckReport> check_playmaker(const PlaymakerCheckOptions& options,
                                          const OnStep& on_step, const std::atomic<int>& stop);

}  // namespace cls::checks
