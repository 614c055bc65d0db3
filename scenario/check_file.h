// Parses the checks of a scenario.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text/json_document.h"
#include "scenario/check.h"

namespace cls::scenario {

/// One element of "expect"; `steps` is the length of the run.
base::Result<Check> parse_check(const base::JsonValue& json, int steps, const base::Json& golden);

/// One element of "until".
base::Result<StepTest> parse_step_test(const base::JsonValue& json);

/// Any text.
base::Result<std::string> text_in(const base::JsonValue& json);

/// [x, y].
base::Result<soccer::Vec2> parse_point(const base::JsonValue& json);

/// "left" or "right".
base::Result<soccer::Side> parse_side(const base::JsonValue& json);

/// A play mode by the referee's name, "kick_in_left".
base::Result<soccer::PlayMode> parse_mode(const base::JsonValue& json);

/// Sets `target` to what `parse` makes of a member, if the object has it.
template <class Parse, class Target>
base::Result<void> parse_if(const base::JsonValue& json, std::string_view key, const Parse& parse,
                            Target& target) {
  if (!json.has(key)) return {};
  TRY_INIT(target, parse(json[key]));
  return {};
}

/// The `parse` of a whole number.
inline auto integer(int low, int high) {
  return [low, high](const base::JsonValue& json) { return json.integer(low, high); };
}

/// The elements of an array, or another value alone.
std::vector<base::JsonValue> elements_of(const base::JsonValue& json);

}  // namespace cls::scenario
