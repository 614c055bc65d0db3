// Appending actions.
#include "player/simple_team/action_list.h"

namespace cls::player {

using Kind = TeamAction::Kind;

void ActionList::add(Kind kind, soccer::Vec2 point, double first, double second, int count) {
  actions_.push_back({kind, static_cast<float>(point.x), static_cast<float>(point.y),
                      static_cast<float>(first), static_cast<float>(second), count});
}

void ActionList::smart_kick(soccer::Vec2 target, double speed, double min_speed, int kicks) {
  add(Kind::kSmartKick, target, speed, min_speed, kicks);
}

void ActionList::dribble(soccer::Vec2 target, double dash_power, int dashes) {
  add(Kind::kDribble, target, dash_power, 0.0, dashes);
}

void ActionList::clear_ball() { add(Kind::kClearBall); }

void ActionList::intercept(soccer::Vec2 face) { add(Kind::kIntercept, face); }

void ActionList::go_to(soccer::Vec2 target, double within, double dash_power) {
  add(Kind::kGoTo, target, within, dash_power);
}

void ActionList::tackle_towards(soccer::Vec2 target, double min_probability) {
  add(Kind::kTackle, target, min_probability);
}

void ActionList::catch_ball() { add(Kind::kCatch); }

void ActionList::turn_to_ball() { add(Kind::kTurnToBall); }

void ActionList::turn_to(soccer::Vec2 target) { add(Kind::kTurnTo, target); }

void ActionList::move_to(soccer::Vec2 target) { add(Kind::kMoveTo, target); }

void ActionList::stand_for_kick_off(soccer::Vec2 target) { add(Kind::kKickOff, target); }

void ActionList::search_ball() { add(Kind::kSearchBall); }

void ActionList::play_penalty() { add(Kind::kPenalty); }

void ActionList::watch_ball() { add(Kind::kWatchBall); }

void ActionList::watch_ball_or_scan(int ball_age) {
  add(Kind::kWatchBallOrScan, {}, 0.0, 0.0, ball_age);
}

void ActionList::watch_goalie_or_scan() { add(Kind::kWatchGoalieOrScan); }

void ActionList::scan() { add(Kind::kScan); }

}  // namespace cls::player
