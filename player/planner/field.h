// Players and ball of the current step, prepared for fast queries of the planner.
#pragma once

#include <array>
#include <vector>

#include "base/fixed_list.h"
#include "player/world/planner_parameters.h"
#include "player/world/running.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Prediction horizon for one action, cycles.
constexpr int kPlannerHorizon = 40;

struct FieldPlayer {
  int unum = 0;  ///< 0: unknown
  int age = 0;   ///< of the position, cycles
  bool goalie = false;
  bool ghost = false;
  bool lying = false;
  Vec2 position;
  Vec2 velocity;
  Vec2 rest;  ///< inertia point: where it stops without dashing
  bool body_known = false;
  Vec2 body;               ///< unit vector
  double turn_cos = -1.0;  ///< of the maximum turn in one cycle
  double turn_sin = 0.0;
  double control = 0.0;     ///< distance within which it kicks
  double unseen_run = 0.0;  ///< distance it may have run since it was seen, meters
  const soccer::PlayerType* type = nullptr;
  const ReachTable* reach = nullptr;
};

/// An opponent that may stop the ball.
struct FieldOpponent : FieldPlayer {
  double speed = 0.0;                           ///< of `velocity`
  std::array<Vec2, kPlannerHorizon + 1> drift;  ///< coasting positions by cycle
  /// Reach from there by cycle.
  std::array<double, kPlannerHorizon + 1> grasp;
};

/// Created once per decision in which the agent has the ball. The world model must outlive it. Own
/// team attacks +x.
class PlannerField {
 public:
  /// `cycles_held`: cycles since the agent got the ball.
  explicit PlannerField(const WorldModel& world, int cycles_held = 0);
  PlannerField(const PlannerField&) = delete;
  PlannerField& operator=(const PlannerField&) = delete;

  const WorldModel& world;
  const PlannerParameters& parameters;
  Vec2 ball;
  Vec2 ball_velocity;
  double kick_limit = 0.0;  ///< maximum acceleration by one kick
  bool open_play = true;    ///< play_on or a penalty kick
  int held = 0;             ///< cycles since the agent got the ball
  FieldPlayer self;
  base::FixedList<FieldPlayer, 22> teammates;
  std::vector<FieldOpponent> opponents;  ///< including players of unknown team
  /// Opponents that stopped the last ball and got to the last point (caches).
  mutable std::size_t last_stopper = 0;
  mutable std::size_t last_arriver = 0;

  /// Distance a ball rolls in `cycles` per unit of initial speed.
  double roll(int cycles) const { return roll_[static_cast<std::size_t>(cycles)]; }
  /// Fraction of the initial speed after `cycles`.
  double speed_left(int cycles) const { return left_[static_cast<std::size_t>(cycles)]; }
  double first_speed(double distance, int cycles) const { return distance / roll(cycles); }
  /// Maximum distance a ball rolls.
  double longest_roll() const { return world.server().ball_speed_max * roll_.back(); }

  /// Number of kicks for that speed along the unit vector: 1 to 3.
  int kicks_for(Vec2 direction, double speed) const;
  /// Player of our team by number, including self; null if unknown.
  const FieldPlayer* our_player(int unum) const;

 private:
  std::array<double, kPlannerHorizon + 1> roll_{};
  std::array<double, kPlannerHorizon + 1> left_{};
  std::vector<ReachTable> reach_;  ///< by type id
};

/// A ball kicked by the agent.
struct BallRoll {
  Vec2 direction;      ///< unit vector
  double speed = 0.0;  ///< first
  int cycles = 0;      ///< until it reaches the target
};

/// Assumptions about opponents.
struct StopRules {
  int head_start = 0;        ///< cycles that opponents have before the ball leaves
  bool count_age = true;     ///< credit for unseen cycles
  double extra_reach = 0.0;  ///< meters
};

/// True if an opponent can intercept the ball before it reaches the target.
bool is_stopped(const PlannerField& field, const BallRoll& roll, const StopRules& rules);

/// Cycles until a player controls a ball at rest at `point`, including turns.
int cycles_to_get(const FieldPlayer& player, Vec2 point);

/// Tolerated angle between body and running direction.
struct Slack {
  double cos = 1.0;
  double sin = 0.0;
};
constexpr Slack kFifteenDegrees{0.96592582628906829, 0.25881904510252076};
/// Slack with which a run over `distance` meters ends within `reach` of its target; at least
/// `least`.
Slack slack_for(double reach, double distance, const Slack& least);
/// Turns (cycles) until the player can run along `way` of `length` meters.
int turns_to_face(const FieldPlayer& player, Vec2 way, double length, const Slack& slack);

/// Minimum cycles_to_get() of the opponents; kNever without opponents.
int opponents_cycles_to(const PlannerField& field, Vec2 point, bool count_age);
/// True if an opponent gets there within `cycles`.
bool opponent_gets_there(const PlannerField& field, Vec2 point, int cycles, bool count_age);
/// Distance to the nearest opponent, meters; 1000 without opponents.
double nearest_opponent(const PlannerField& field, Vec2 point);

}  // namespace cls::player
