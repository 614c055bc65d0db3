// Bundled behaviors without soccer knowledge of their own.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "mock-server/behavior/behavior.h"

namespace cls::mock_server {

/// Sends high-level actions only, as upstream's sample Playmakers do: goalie, shot and planner for
/// the ball holder, basic move, set play, penalty. It plays as well as the proxy's behaviors do.
std::unique_ptr<Behavior> make_planner_behavior();

/// One to four random actions per cycle, of any kind with any arguments; tests that the proxy and
/// the server survive them. Drawn from seed, uniform number and cycle.
std::unique_ptr<Behavior> make_random_behavior(std::uint64_t seed);

/// Repeats the recorded reply for the same side, uniform number, cycle and stopped time, or sends
/// no actions where the recording has none. The error names the file.
base::Result<std::unique_ptr<Behavior>> read_replay_behavior(const std::string& path);

}  // namespace cls::mock_server
