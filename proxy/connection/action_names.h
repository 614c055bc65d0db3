// Names of actions on the wire, and counts by name.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "player/planner/action_report.h"

namespace cls::proxy {

/// The field name in playmaker.proto ("body_go_to_point"); "unknown" for 0 and out of range.
std::string_view action_name(int kind);
std::string_view say_name(int kind);

/// Counts by outcome ("executed", "failed", "skipped", "invalid", "unimplemented"), without zeros,
/// by the name of the action; members of Say are named "say.MEMBER".
using ActionOutcomes = std::map<std::string, std::map<std::string, std::int64_t>>;
ActionOutcomes outcomes_by_name(const player::ActionReport& report);

/// Requested actions unknown to this proxy, by the same names, without zeros.
std::map<std::string, std::int64_t> unimplemented_by_name(const player::ActionReport& report);

/// The proxy's own decisions by reason ("preprocess", "sure_shot", "intention", "force_kick",
/// "heard_pass"), without zeros.
std::map<std::string, std::int64_t> automatic_by_name(const player::ActionReport& report);

}  // namespace cls::proxy
