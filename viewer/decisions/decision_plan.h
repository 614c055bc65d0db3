// What a player considered before it chose, from the recorded text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.h"

namespace cls::viewer {

/// A first action of the planner, or an option of a policy.
struct ConsideredAction {
  bool chosen = false;
  std::string name;                    ///< "through pass"
  int unum = 0;                        ///< the player who gets the ball; 0: not named
  bool is_share = false;               ///< of a policy
  double value = 0.0;                  ///< a probability in percent, or the planner's value
  std::optional<soccer::Vec2> target;  ///< meters, of the own team's view: it attacks to the right
  std::optional<double> room;          ///< distance of the nearest opponent to the target, meters
};

/// DecisionSample::plan, the best first and of equal ones the chosen one. What is not a line of
/// the format is left out.
std::vector<ConsideredAction> considered_actions(std::string_view plan);

}  // namespace cls::viewer
