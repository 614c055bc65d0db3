// Goals against and chances wasted, by how they began and how they ended.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "soccer/side.h"

namespace cls::review {

/// A goal against a team, or a shot of it without a goal.
struct Chance {
  std::size_t frame = 0;
  int cycle = 0;
  double worth = 1.0;  ///< goals that it cost: 1 for a goal, the chance of a goal for a shot
  std::string origin;  ///< how the attacking team got the ball: "set play", "pass lost in middle"
  std::string finish;  ///< the last pass, and from where the shot came: "cross, close shot"
};

/// In the order of the match.
struct Chances {
  std::vector<Chance> against;  ///< goals
  std::vector<Chance> wasted;   ///< shots of the team that were no goals
};
Chances find_chances(const analysis::MatchStatistics& match, soccer::Side side);

/// A place in a match: index of the match, and the cycle.
struct Place {
  std::size_t match = 0;
  int cycle = 0;
};

/// Chances of one origin or finish.
struct ChanceClass {
  std::string name;
  std::size_t chances = 0;
  double worth = 0.0;
  Place worst;  ///< the one that cost most; of equal ones the first
};

/// By worth, highest first. `field` is &Chance::origin or &Chance::finish; `chances` by match.
std::vector<ChanceClass> classes_of(const std::vector<std::vector<Chance>>& chances,
                                    std::string Chance::*field);

}  // namespace cls::review
