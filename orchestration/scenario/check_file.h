// Reading the demands of a scenario.
#pragma once

#include "mock-server/json_text.h"
#include "orchestration/scenario/check.h"
#include "soccer/result.h"

namespace cls::orchestration {

/// One element of "expect"; `steps` is the length of the run.
soccer::Result<Check> parse_check(const mock_server::JsonValue& json, int steps,
                                  const mock_server::Json& golden);

/// One element of "until".
soccer::Result<StepTest> parse_step_test(const mock_server::JsonValue& json);

/// [x, y].
soccer::Result<soccer::Vec2> parse_point(const mock_server::JsonValue& json);

/// "left" or "right".
soccer::Result<soccer::Side> parse_side(const mock_server::JsonValue& json);

/// A play mode by the referee's name, "kick_in_left".
soccer::Result<soccer::PlayMode> parse_mode(const mock_server::JsonValue& json);

}  // namespace cls::orchestration
