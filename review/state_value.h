// The value of a moment: the chances of both teams to score soon, fitted to recorded matches.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "analysis/play/flow.h"
#include "simulator/world/world.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::review {

/// Ball, players and who has the ball, in the coordinates of logs. Meters, meters per cycle.
struct StateView {
  soccer::Vec2 ball;
  soccer::Vec2 ball_velocity;
  std::array<soccer::Vec2, soccer::kPlayersOnPitch> players{};  ///< by slot
  std::array<bool, soccer::kPlayersOnPitch> on_pitch{};
  /// The side of the last toucher; in set plays the side that takes it; neutral: nobody.
  soccer::Side owner = soccer::Side::kNeutral;
};

StateView view_of(const analysis::Flow& flow, std::size_t frame);
StateView view_of(const simulator::World& world);

inline constexpr std::array<std::string_view, 9> kStateFigures = {
    "constant",      "has_ball",          "ball_x",
    "closeness",     "closeness_squared", "closeness_of_owner",
    "speed_to_goal", "opponents_behind",  "teammates_ahead"};
using StateFigures = std::array<double, kStateFigures.size()>;

/// The figures of a moment as `side` sees it, which attacks +x:
/// 1; 1 if it has the ball; x of the ball in half pitch lengths; how close the ball is to their
/// goal (1 in its middle, 0 from 40 m on), its square, and it if the side has the ball; velocity
/// of the ball along x in 2.7 m per cycle; opponents between ball and their goal line, and
/// teammates there, as shares of a team.
StateFigures figures_of(const StateView& view, soccer::Side side);

/// The cycles in which a goal counts.
inline constexpr int kValueHorizon = 150;

/// The chance (0..1) that a side scores within kValueHorizon cycles.
double chance_to_score(const StateFigures& figures);
double chance_to_score(const StateView& view, soccer::Side side);

/// The goals that a moment is worth to `side`: its chance to score minus the other's.
double state_value(const StateView& view, soccer::Side side);

const StateFigures& state_weights();

/// How well chances agree with goals: moments by their chance.
struct CalibrationBin {
  std::size_t moments = 0;
  double chance = 0.0;  ///< mean
  double goals = 0.0;   ///< share of moments after which the side scored
};

/// Fits the weights by logistic regression, to both views of every tenth live frame of matches.
class StateFitter {
 public:
  void add(const analysis::Flow& flow);

  std::size_t rows() const { return rows_.size(); }
  std::size_t goals() const;
  /// Maximum likelihood with a weak pull towards 0.
  StateFigures fit() const;
  /// Of chance_to_score() on these moments: bins of equal numbers of them, by rising chance.
  std::vector<CalibrationBin> calibration(std::size_t count) const;

 private:
  struct Row {
    StateFigures figures;
    bool goal;
  };
  std::vector<Row> rows_;
};

}  // namespace cls::review
