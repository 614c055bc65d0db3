// Parses the checks of a scenario.
#pragma once

#include "base/result.h"
#include "base/text/json_document.h"
#include "scenario/check.h"

namespace cls::scenario {

/// One element of "expect"; `steps` is the length of the run.
base::Result<Check> parse_check(const base::JsonValue& json, int steps, const base::Json& golden);

/// One element of "until".
base::Result<StepTest> parse_step_test(const base::JsonValue& json);

/// [x, y].
base::Result<soccer::Vec2> parse_point(const base::JsonValue& json);

/// "left" or "right".
base::Result<soccer::Side> parse_side(const base::JsonValue& json);

/// A play mode by the referee's name, "kick_in_left".
base::Result<soccer::PlayMode> parse_mode(const base::JsonValue& json);

}  // namespace cls::scenario
