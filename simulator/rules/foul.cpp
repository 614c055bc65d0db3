// Foul rule: detects fouls by tackles (docs/spec/simulation-model.md 4.15) and calls them
// (docs/spec/simulation-model.md 9.10).
#include "simulator/rules/foul.h"

#include <cmath>

#include "simulator/referee/areas.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

void freeze(const World& world, Player& victim) {
  victim.foul_cycles = world.params().foul_cycles;
  victim.command_done = true;
  victim.state |= state::kFoulCharged;
}

// True if the victim dashes, is closer than the ball, stands in the path to it, and faces it.
bool is_in_path_to_ball(const World& world, const Player& tackler, const Player& victim) {
  if (victim.dash_cycles < 0) return false;
  const Vec2 to_ball = world.ball.position - tackler.position;
  const Vec2 to_victim = victim.position - tackler.position;
  if (to_victim.squared_length() > to_ball.squared_length()) return false;
  const double direction = soccer::direction_radians(to_ball);
  const Vec2 ahead = soccer::rotated_radians(to_victim, -direction);
  const double width = world.type_of(victim).player_size + world.type_of(tackler).player_size;
  if (ahead.x < 0.0 || std::fabs(ahead.y) > width) return false;
  return std::fabs(math::normalize_radians(victim.body - direction)) <= math::kPi / 2.0;
}

void call_foul(World& world, Player& tackler, Events& events) {
  const Side side = tackler.side;
  ++tackler.fouls;
  world.ball_catcher = kNoPlayer;
  world.referee.foul.counter = 0;
  const Vec2 position = move_out_of_penalty_area(
      opponent(side), move_out_of_goal_area(Side::kNeutral, clamp_to_pitch(tackler.position)));
  place_ball(world, for_side(PlayMode::kFoulChargeLeft, side), opponent(side), position, events);
}

void tackle_taken(World& world, Player& tackler, double, bool foul, Events& events) {
  if (soccer::is_penalty_mode(world.mode) || world.params().keepaway) return;
  const FoulCall call = detect_foul(world, tackler, foul);
  if (call == FoulCall::kNone) return;
  call_foul(world, tackler, events);
  if (call == FoulCall::kYellow) show_yellow_card(world, tackler, events);
  if (call == FoulCall::kRed) show_red_card(world, tackler, events);
}

void analyze(World& world, Events& events) {
  if (!is_foul(world.mode)) return;
  const Side offender = soccer::side(world.mode);
  if (!wait_after_offense(world, world.referee.foul.counter, offender, events)) return;
  const PlayMode kick = in_penalty_area(offender, world.ball.position)
                            ? PlayMode::kIndirectFreeKickLeft
                            : PlayMode::kFreeKickLeft;
  change_mode(world, for_side(kick, opponent(offender)), events);
}

}  // namespace

FoulCall detect_foul(World& world, const Player& tackler, bool foul) {
  const Slot slot = tackler.slot();
  RandomStream& stream = world.random.foul[static_cast<std::size_t>(slot)];
  const double probability = world.type_of(tackler).foul_detect_probability;
  const double red_probability = world.params().red_card_probability;
  bool charge = false;
  bool yellow = false;
  bool red = false;
  bool drawn = false;

  for (Player& victim : world.players) {
    if (!victim.enabled || victim.side == tackler.side || !is_kickable(world, victim)) continue;
    bool detected = false;
    if (foul) {
      freeze(world, victim);
      drawn = true;
      detected = stream.bernoulli(probability);
      charge = charge || detected;
    }

    if (!is_in_path_to_ball(world, tackler, victim)) continue;
    if (foul) {
      if (detected) (stream.bernoulli(red_probability) ? red : yellow) = true;
      continue;
    }
    drawn = true;
    if (!stream.bernoulli(probability)) continue;
    charge = true;
    if (stream.bernoulli(red_probability)) yellow = true;
  }

  const FoulCall call = red      ? FoulCall::kRed
                        : yellow ? FoulCall::kYellow
                        : charge ? FoulCall::kCharge
                                 : FoulCall::kNone;
  return drawn && world.overrides ? world.overrides->foul.replace(slot, call) : call;
}

const Rule kFoulRule = {.analyze = analyze, .tackle_taken = tackle_taken};

}  // namespace cls::simulator
