// Actions of the simple team as plain data, in the order of preference.
#pragma once

#include "base/fixed_list.h"
#include "soccer/geometry.h"

namespace cls::player {

using soccer::Vec2;

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

  Vec2 point() const { return {x, y}; }
};

/// Collects actions. The agent tries body actions in sequence until one succeeds and executes all
/// neck and view actions, so the order of calls is the order of preference.
class ActionList {
 public:
  // Actions with the ball. Speeds are in meters per cycle.
  void smart_kick(Vec2 target, double speed, double min_speed, int kicks) {
    add(Kind::kSmartKick, target, speed, min_speed, kicks);
  }
  void dribble(Vec2 target, double dash_power, int dashes) {
    add(Kind::kDribble, target, dash_power, 0.0, dashes);
  }
  void clear_ball() { add(Kind::kClearBall); }

  // Without the ball.
  void intercept(Vec2 face) { add(Kind::kIntercept, face); }
  void go_to(Vec2 target, double within, double dash_power) {
    add(Kind::kGoTo, target, within, dash_power);
  }
  void tackle_towards(Vec2 target, double min_probability) {
    add(Kind::kTackle, target, min_probability);
  }
  void catch_ball() { add(Kind::kCatch); }
  void turn_to_ball() { add(Kind::kTurnToBall); }
  void turn_to(Vec2 target) { add(Kind::kTurnTo, target); }
  void move_to(Vec2 target) { add(Kind::kMoveTo, target); }
  void stand_for_kick_off(Vec2 target) { add(Kind::kKickOff, target); }
  void search_ball() { add(Kind::kSearchBall); }
  void play_penalty() { add(Kind::kPenalty); }

  // Neck and view.
  void watch_ball() { add(Kind::kWatchBall); }
  void watch_ball_or_scan(int ball_age) { add(Kind::kWatchBallOrScan, {}, 0.0, 0.0, ball_age); }
  void watch_goalie_or_scan() { add(Kind::kWatchGoalieOrScan); }
  void scan() { add(Kind::kScan); }

  /// No decision has more.
  static constexpr std::size_t kMaxActions = 12;
  const base::FixedList<TeamAction, kMaxActions>& actions() const { return actions_; }

  bool places_itself = false;  ///< the agent must not place itself by its own formation

 private:
  using Kind = TeamAction::Kind;

  void add(Kind kind, Vec2 point = {}, double first = 0.0, double second = 0.0, int count = 0) {
    actions_.push_back({kind, static_cast<float>(point.x), static_cast<float>(point.y),
                        static_cast<float>(first), static_cast<float>(second), count});
  }

  base::FixedList<TeamAction, kMaxActions> actions_;
};

}  // namespace cls::player
