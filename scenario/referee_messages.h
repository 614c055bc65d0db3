// The messages of the referee, for validating scenarios.
#pragma once

#include <string_view>
#include <vector>

namespace cls::scenario {

/// True for messages that the referee can send: play modes, "half_time", "goal_l_2",
/// "yellow_card_r_5", ...
bool is_referee_message(std::string_view message);

/// All messages without a number, and one example of each numbered kind, for suggestions.
const std::vector<std::string_view>& referee_messages();

}  // namespace cls::scenario
