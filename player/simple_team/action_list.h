// Actions of the simple team as plain data, in the order of preference.
#pragma once

#include "base/fixed_list.h"
#include "soccer/geometry.h"

namespace cls::player {

/// Distance at which the target of a dribble is reached, meters.
constexpr float kDribbleDistance = 1.0F;

/// One action, with the numbers as a message carries them.
struct TeamAction {
  enum class Kind : unsigned char {
    kSmartKick,  ///< point; speed, least speed of the first kick; kicks
    kDribble,    ///< point; dash power; dashes
    kClearBall,
    kIntercept,  ///< point to face
    kGoTo,       ///< point; distance that is near enough, dash power
    kTackle,     ///< point; least probability
    kCatch,
    kTurnToBall,
    kTurnTo,   ///< point
    kMoveTo,   ///< point
    kKickOff,  ///< point to stand at
    kSearchBall,
    kPenalty,
    // Neck and view.
    kWatchBall,
    kWatchBallOrScan,  ///< age of the ball in cycles
    kWatchGoalieOrScan,
    kScan,
  };

  Kind kind = Kind::kScan;
  float x = 0.0F;
  float y = 0.0F;
  float first = 0.0F;
  float second = 0.0F;
  int count = 0;

  soccer::Vec2 point() const { return {x, y}; }
};

/// Collects actions. The agent tries body actions in sequence until one succeeds and executes all
/// neck and view actions, so the order of calls is the order of preference.
class ActionList {
 public:
  // Actions with the ball. Speeds are in meters per cycle.
  void smart_kick(soccer::Vec2 target, double speed, double min_speed, int kicks);
  void dribble(soccer::Vec2 target, double dash_power, int dashes);
  void clear_ball();

  // Without the ball.
  void intercept(soccer::Vec2 face);
  void go_to(soccer::Vec2 target, double within, double dash_power);
  void tackle_towards(soccer::Vec2 target, double min_probability);
  void catch_ball();
  void turn_to_ball();
  void turn_to(soccer::Vec2 target);
  void move_to(soccer::Vec2 target);
  void stand_for_kick_off(soccer::Vec2 target);
  void search_ball();
  void play_penalty();

  // Neck and view.
  void watch_ball();
  void watch_ball_or_scan(int ball_age);
  void watch_goalie_or_scan();
  void scan();

  /// No decision has more.
  static constexpr std::size_t kMaxActions = 12;
  const base::FixedList<TeamAction, kMaxActions>& actions() const { return actions_; }

  bool places_itself = false;  ///< the agent must not place itself by its own formation

 private:
  void add(TeamAction::Kind kind, soccer::Vec2 point = {}, double first = 0.0, double second = 0.0,
           int count = 0);

  base::FixedList<TeamAction, kMaxActions> actions_;
};

}  // namespace cls::player
