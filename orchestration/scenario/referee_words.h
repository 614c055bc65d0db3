// The words of the referee, so that a scenario cannot wait for one that does not exist.
#pragma once

#include <string_view>
#include <vector>

namespace cls::orchestration::scenario {

/// True for what the referee can say: play modes, "half_time", "goal_l_2", "yellow_card_r_5", ...
bool is_referee_word(std::string_view word);

/// All of them that carry no number, and one of each kind that does.
const std::vector<std::string_view>& referee_words();

}  // namespace cls::orchestration::scenario
