// Calls the rules in their fixed order, places the ball for set plays and shows cards.
#include "simulator/referee/referee.h"

#include <array>

#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/rule.h"
#include "simulator/world/roster.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

constexpr std::array<const Rule*, 10> kRules = {
    &kTimeRule,  &kBallStuckRule, &kOffsideRule,        &kFreeKickRule, &kTouchRule,
    &kCatchRule, &kFoulRule,      &kIllegalDefenseRule, &kKeepawayRule, &kPenaltyRule};

template <typename Member, typename... Arguments>
void notify_rules(World& world, Member Rule::*handler, Arguments&&... arguments) {
  if (!world.rules->has_referee()) return;
  for (const Rule* rule : kRules) {
    if (rule->*handler != nullptr) (rule->*handler)(world, arguments...);
  }
}

Side kick_off_side_after(PlayMode mode, Side before) {
  if (soccer::is_set_play(mode)) return soccer::side(mode);
  if (is_either(mode, PlayMode::kIllegalDefenseLeft)) return opponent(soccer::side(mode));
  return mode == PlayMode::kDropBall ? Side::kNeutral : before;
}

double with_sign_of(double y, double distance) { return y > 0.0 ? distance : -distance; }

}  // namespace

void run_referee(World& world, Events& events) { notify_rules(world, &Rule::analyze, events); }

void on_kick_taken(World& world, Slot kicker, double acceleration, Events& events) {
  notify_rules(world, &Rule::kick_taken, world.player(kicker), acceleration, events);
}

void on_tackle_taken(World& world, Slot tackler, double acceleration, bool foul, Events& events) {
  if (!world.rules->has_referee()) return;
  Player& player = world.player(tackler);
  for (const Rule* rule : kRules) {
    if (rule->tackle_taken != nullptr) {
      rule->tackle_taken(world, player, acceleration, foul, events);
    } else if (rule->kick_taken != nullptr) {
      rule->kick_taken(world, player, acceleration, events);
    }
  }
}

void on_ball_missed(World& world, Slot player, Events& events) {
  notify_rules(world, &Rule::ball_missed, world.player(player), events);
}

void on_ball_touched(World& world, Slot toucher, Events& events) {
  notify_rules(world, &Rule::ball_touched, world.player(toucher), events);
}

void on_ball_caught(World& world, Slot catcher, Events& events) {
  notify_rules(world, &Rule::ball_caught, world.player(catcher), events);
}

void on_ball_punched(World& world, Slot catcher, Events& events) {
  notify_rules(world, &Rule::ball_punched, world.player(catcher), events);
}

void change_mode(World& world, PlayMode mode, Events& events) {
  world.mode = mode;
  notify_rules(world, &Rule::mode_changed, mode, events);
  world.kick_off_side = kick_off_side_after(mode, world.kick_off_side);
  if (mode == PlayMode::kPlayOn) world.last_play_on = world.clock.time;
  report(events, world, ModeChanged{mode});
  if (!is_goal(mode)) announce(world, {name(mode)}, events);
}

bool wait_after_offense(World& world, int& counter, Side offender, Events& events) {
  constexpr int kWait = 30;
  constexpr int kCleared = 5;
  ++counter;
  if (counter > kWait - kCleared) clear_players_from_ball(world, offender, events);
  return counter > kWait;
}

void announce(World& world, const RefereeMessage& message, Events& events) {
  report(events, world, message);
}

void place_ball(World& world, Side side, Vec2 position) {
  world.ball = {position, {}, {}};
  world.kick_off_side = side;
}

void place_ball(World& world, PlayMode mode, Side side, Vec2 position, Events& events) {
  place_ball(world, side, position);
  const bool resumes = mode == PlayMode::kPlayOn || mode == PlayMode::kDropBall;
  if (resumes && soccer::is_penalty_mode(world.mode)) return;
  change_mode(world, mode, events);
}

void award_free_kick(World& world, Side side, Vec2 position, Events& events) {
  place_ball(world, for_side(PlayMode::kFreeKickLeft, side), side,
             move_out_of_penalty_area(opponent(side), clamp_to_pitch(position)), events);
}

void award_goal_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  const double x = -sign(side) * (soccer::kHalfLength - soccer::kGoalAreaLength);
  const double y = with_sign_of(world.ball.position.y, soccer::kGoalAreaWidth / 2.0);
  place_ball(world, for_side(PlayMode::kGoalKickLeft, side), side, {x, y}, events);
}

void award_corner_kick(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  const double margin = world.params().ckick_margin;
  const double x = sign(side) * (soccer::kHalfLength - margin);
  const double y = with_sign_of(world.ball.position.y, soccer::kHalfWidth - margin);
  place_ball(world, for_side(PlayMode::kCornerKickLeft, side), side, {x, y}, events);
}

void award_kick_in(World& world, Side side, Events& events) {
  world.ball_catcher = kNoPlayer;
  place_ball(world, for_side(PlayMode::kKickInLeft, side), side,
             clamp_to_pitch(world.ball.position), events);
}

void drop_ball(World& world, Events& events) {
  drop_ball(world, move_out_of_penalty_area(Side::kNeutral, clamp_to_pitch(world.ball.position)),
            events);
}

void drop_ball(World& world, Vec2 position, Events& events) {
  world.ball_catcher = kNoPlayer;
  place_ball(world, PlayMode::kDropBall, Side::kNeutral, position, events);
  keep_players_in_field(world);
  if (!soccer::is_penalty_mode(world.mode)) change_mode(world, PlayMode::kPlayOn, events);
}

void show_yellow_card(World& world, Player& player, Events& events) {
  announce(world, {"yellow_card", player.side, player.unum}, events);
  ++player.cards;
  player.state |= state::kYellowCard;
  if (player.cards > 1) show_red_card(world, player, events);
}

void show_red_card(World& world, Player& player, Events& events) {
  announce(world, {"red_card", player.side, player.unum}, events);
  send_off(world, player.slot(), events);
}

}  // namespace cls::simulator
