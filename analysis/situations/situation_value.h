// The value of a played situation: goals, expected goals and territory, in goals a match.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// Figures of some frames of a match, left minus right.
struct SituationFigures {
  double goals = 0.0;
  double expected_goals = 0.0;   ///< of the shots (docs/spec/match-statistics.md 3.5)
  double mean_ball_x = 0.0;      ///< half pitch lengths, -1 to 1, over the frames
  double mean_possession = 0.0;  ///< +1, -1: last toucher; 0: none
  double mean_danger = 0.0;      ///< as end_danger, over the frames
  double end_ball_x = 0.0;       ///< the same in the last frame; 0 after a goal
  double end_possession = 0.0;   ///< +1, -1: last toucher in the last frame; 0: none, or a goal
  /// Closeness of the ball to the right goal minus that to the left one in the last frame: 1 in the
  /// goal, 0 from 40 m on; 0 after a goal.
  double end_danger = 0.0;

  std::array<double, 8> values() const {
    return {goals,       expected_goals, mean_ball_x,    mean_possession,
            mean_danger, end_ball_x,     end_possession, end_danger};
  }
};

inline constexpr std::array<std::string_view, 8> kFigureNames = {
    "goals",       "expected_goals", "mean_ball_x",    "mean_possession",
    "mean_danger", "end_ball_x",     "end_possession", "end_danger"};

/// The figures of the frames from `begin` to `end` - 1. A goal ends them.
SituationFigures figures_of(const Flow& flow, std::size_t begin, std::size_t end);

/// The value of a situation of 50 cycles, in goals a match of 6000 cycles: the sum of the figures,
/// each times its weight, times a scale. docs/tournaments.md says how weights and scale follow from
/// whole matches; `cls book fit` computes the weights.
double situation_value(const SituationFigures& figures);

/// In the order of kFigureNames.
const std::array<double, 8>& situation_weights();

}  // namespace cls::analysis
