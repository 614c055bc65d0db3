// Judging tackles.
#include "simulator/rules/foul_detection.h"

#include <cmath>

namespace cls::simulator {
namespace {

namespace math = soccer::math;

void freeze(const World& world, Player& victim) {
  victim.foul_cycles = world.params().foul_cycles;
  victim.command_done = true;
  victim.state |= state::kFoulCharged;
}

// Dashing, nearer than the ball, in its way, and turned from the tackler towards the ball.
bool is_run_into(const World& world, const Player& tackler, const Player& victim) {
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

}  // namespace

FoulCall detect_foul(World& world, const Player& tackler, bool foul) {
  const auto slot = static_cast<std::size_t>(tackler.slot());
  RandomStream& stream = world.random.foul[slot];
  const double probability = world.type_of(tackler).foul_detect_probability;
  const double red_probability = world.params().red_card_probability;
  bool charge = false;
  bool yellow = false;
  bool red = false;
  bool drawn = false;
  for (Player& victim : world.players) {
    if (!victim.enabled || victim.side == tackler.side || !is_kickable(world, victim)) continue;
    bool seen = false;
    if (foul) {
      freeze(world, victim);
      drawn = true;
      seen = stream.bernoulli(probability);
      charge = charge || seen;
    }
    if (!is_run_into(world, tackler, victim)) continue;
    if (foul) {
      if (seen) (stream.bernoulli(red_probability) ? red : yellow) = true;
      continue;
    }
    drawn = true;
    if (!stream.bernoulli(probability)) continue;
    charge = true;
    if (stream.bernoulli(red_probability)) yellow = true;
  }
  if (drawn && world.forced) {
    world.forced->foul_drawn.set(slot);
    if (world.forced->foul[slot]) return *world.forced->foul[slot];
  }
  if (red) return FoulCall::kRed;
  if (yellow) return FoulCall::kYellow;
  return charge ? FoulCall::kCharge : FoulCall::kNone;
}

}  // namespace cls::simulator
