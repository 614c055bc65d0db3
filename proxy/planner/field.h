// What the planner works on: players and ball of this moment, prepared for thousands of questions.
#pragma once

#include <array>
#include <vector>

#include "proxy/planner/reach.h"
#include "proxy/world/fixed_list.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Cycles the planner looks ahead for one action.
constexpr int kPlannerHorizon = 40;

struct FieldPlayer {
  int unum = 0;  ///< 0: not known
  int age = 0;   ///< of the belief about its place, cycles
  bool goalie = false;
  bool ghost = false;
  bool lying = false;
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  soccer::Vec2 rest;  ///< where it comes to when it never dashes again
  bool body_known = false;
  soccer::Vec2 body;       ///< unit vector
  double turn_cos = -1.0;  ///< of the largest turn of one cycle
  double turn_sin = 0.0;
  double control = 0.0;     ///< distance within which it kicks
  double unseen_run = 0.0;  ///< metres it may have run since it was seen
  const soccer::PlayerType* type = nullptr;
  const ReachTable* reach = nullptr;
};

/// An opponent as the stopper of balls.
struct FieldOpponent : FieldPlayer {
  std::array<soccer::Vec2, kPlannerHorizon + 1> drift;  ///< places by cycles when it only coasts
  /// Farthest from there that it can have the ball by then.
  std::array<double, kPlannerHorizon + 1> grasp;
};

/// Made once per decision in which the agent has the ball; refers to the world, which must outlive
/// it. Coordinates: own team attacks +x.
class PlannerField {
 public:
  /// `cycles_held`: for how long the agent has had the ball.
  explicit PlannerField(const WorldModel& world, int cycles_held = 0);
  PlannerField(const PlannerField&) = delete;
  PlannerField& operator=(const PlannerField&) = delete;

  const WorldModel& world;
  soccer::Vec2 ball;
  soccer::Vec2 ball_velocity;
  double kick_limit = 0.0;  ///< acceleration that one kick gives the ball
  bool open_play = true;    ///< play_on or a penalty kick
  int held = 0;             ///< cycles for which the agent has had the ball
  FieldPlayer self;
  FixedList<FieldPlayer, 22> mates;
  std::vector<FieldOpponent> opponents;  ///< with those whose team is not known
  mutable std::size_t last_stopper = 0;  ///< index of who stopped the last ball; for speed only

  /// Distance a ball covers in n cycles per unit of first speed.
  double roll(int cycles) const { return roll_[static_cast<std::size_t>(cycles)]; }
  /// Share of the first speed left after n cycles.
  double speed_left(int cycles) const { return left_[static_cast<std::size_t>(cycles)]; }
  double first_speed(double distance, int cycles) const { return distance / roll(cycles); }
  /// Farthest a ball rolls.
  double longest_roll() const { return world.server().ball_speed_max * roll_.back(); }

  /// Kicks needed to send the ball along the unit vector with that speed: 1 to 3.
  int kicks_for(soccer::Vec2 direction, double speed) const;
  /// Own team's player by number, self included; null when not known.
  const FieldPlayer* ours(int unum) const;

 private:
  std::array<double, kPlannerHorizon + 1> roll_{};
  std::array<double, kPlannerHorizon + 1> left_{};
  std::vector<ReachTable> reach_;  ///< by type id
};

/// A ball on its way from the agent's feet.
struct BallRoll {
  soccer::Vec2 direction;  ///< unit vector
  double speed = 0.0;      ///< first
  int cycles = 0;          ///< until it is where it is meant to be
};

/// Which opponents are asked, and how much they are given.
struct StopRules {
  int head_start = 0;        ///< cycles that opponents have before the ball leaves
  bool count_age = true;     ///< what was not seen lately may have come nearer
  double extra_reach = 0.0;  ///< metres
};

/// True when an opponent can have the ball before it is there.
bool is_stopped(const PlannerField& field, const BallRoll& roll, const StopRules& rules);

/// Cycles a player needs until it can have a ball at rest at `point`, turns included.
int cycles_to_get(const FieldPlayer& player, soccer::Vec2 point);

/// How far off its way a runner's body may point.
struct Slack {
  double cos = 1.0;
  double sin = 0.0;
};
constexpr Slack kFifteenDegrees{0.96592582628906829, 0.25881904510252076};
/// So that a run over `distance` metres passes within `reach` of its end; at least `least`.
Slack slack_for(double reach, double distance, const Slack& least);
/// Turns (cycles) until the player can run along `way`, which is `length` metres long.
int turns_to_face(const FieldPlayer& player, soccer::Vec2 way, double length, const Slack& slack);

/// The opponent that is first at `point` by cycles_to_get(); kNever without any.
int opponents_cycles_to(const PlannerField& field, soccer::Vec2 point, bool count_age);
/// True when that is not later than `cycles`.
bool opponent_gets_there(const PlannerField& field, soccer::Vec2 point, int cycles, bool count_age);
/// Metres to the opponent nearest to the point; 1000 without any.
double nearest_opponent(const PlannerField& field, soccer::Vec2 point);

}  // namespace cls::proxy
