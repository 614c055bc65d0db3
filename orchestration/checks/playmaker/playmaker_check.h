// `cls check playmaker`: is it a Playmaker that matches can be played with?
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "orchestration/checks/playmaker/playmaker_subject.h"
#include "orchestration/match/options/endpoint.h"

namespace cls::orchestration::checks {

struct PlaymakerCheckOptions {
  match::Endpoint endpoint;  ///< not a team
  Milliseconds start_timeout{20'000};
  Milliseconds deadline{3'000};
  int calls = 10'000;
  Milliseconds latency_limit{100};
  std::vector<std::string> only;  ///< the steps to take; empty: all
};

/// Called after each step.
using OnStep = std::function<void(const CheckStep&)>;

/// Takes all steps; what was started is ended. A Playmaker that cannot be reached fails its first
/// step, and the others are skipped. The error says why nothing could be tried: a bad script, no
/// process. `stop` nonzero skips what is left.
base::Result<CheckReport> check_playmaker(const PlaymakerCheckOptions& options,
                                          const OnStep& on_step, const std::atomic<int>& stop);

}  // namespace cls::orchestration::checks
