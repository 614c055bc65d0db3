// Behaviors by name, as `mock:NAME` and scripts refer to them.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "mock-server/behavior/behavior.h"

namespace cls::mock_server {

/// The behavior of `mock` without a name.
inline constexpr std::string_view kDefaultBehavior = "attack";

/// Names without arguments that make_behavior() accepts.
std::vector<std::string_view> behavior_names();

/// An empty name selects the default. "random" may be followed by a seed, "random:7";
/// "replay:FILE" repeats a recording. The error suggests a name.
base::Result<std::unique_ptr<Behavior>> make_behavior(std::string_view name);

}  // namespace cls::mock_server
