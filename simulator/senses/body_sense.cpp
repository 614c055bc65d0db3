// Rounding a player's own state for sense_body (docs/spec/simulation-model.md 7.9).
#include "simulator/senses/body_sense.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/actions/actions.h"
#include "simulator/world/angles.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr double kSpeedStep = 0.01;

// A player that points infinitely far away has a NaN direction; rcssserver on x86 converts it to
// the smallest int.
int to_int(double value) {
  return std::isnan(value) ? std::numeric_limits<int>::min() : static_cast<int>(value);
}

}  // namespace

soccer::CommandCounts command_counts(const Counters& counters) {
  return {counters.kick, counters.dash,        counters.turn,
          counters.say,  counters.turn_neck,   counters.catches,
          counters.move, counters.change_view, counters.change_focus};
}

soccer::Card card(const Player& player) {
  if (player.has(state::kRedCard)) return soccer::Card::kRed;
  return player.has(state::kYellowCard) ? soccer::Card::kYellow : soccer::Card::kNone;
}

// Converts to polar coordinates twice, as rcssserver does: this decides the direction of a player
// that points at itself or infinitely far away.
ArmAim arm_aim(const Player& player) {
  const Vec2 offset = player.arm.target - player.position;
  const double direction = math::atan2(offset.y, offset.x) - (player.body + player.neck);
  const Vec2 target = soccer::polar_radians(offset.length(), direction);
  return {target.length(), math::atan2(target.y, target.x)};
}

soccer::ArmState arm_state(const World& world, const Player& player, bool rounded) {
  soccer::ArmState arm;
  arm.movable_in = std::max(0, world.params().point_to_ban - player.arm.age);
  arm.expires_in = std::max(0, world.params().point_to_duration - player.arm.age);
  arm.count = player.counters.pointto;
  if (!is_pointing(world, player)) return arm;
  const ArmAim aim = arm_aim(player);
  const double direction = exact_degrees(aim.direction);
  const double distance = aim.distance;
  if (rounded) {
    arm.target_distance = std::rint(distance * 10.0) * 0.1;
    arm.target_direction = to_int(std::rint(direction * 10.0) * 0.1);
  } else {
    arm.target_distance = distance;
    arm.target_direction = to_int(std::rint(direction));
  }
  return arm;
}

soccer::SenseBody sense_body(const World& world, Slot slot) {
  const Player& player = world.player(slot);
  soccer::SenseBody sense;
  sense.time = world.clock.time;
  sense.quality = player.view.quality;
  sense.width = player.view.width;
  sense.stamina = player.stamina.value;
  sense.effort = player.stamina.effort;
  sense.capacity = player.stamina.capacity;

  sense.speed = math::quantize(player.velocity.length(), kSpeedStep);
  sense.speed_direction = truncated_degrees(math::normalize_radians(
      soccer::direction_radians(player.velocity) - player.body - player.neck));
  sense.head_angle = truncated_degrees(player.neck);

  sense.counts = command_counts(player.counters);
  sense.arm = arm_state(world, player, true);
  if (player.attention != kNoPlayer) {
    sense.attention_side = soccer::side_of_slot(player.attention);
    sense.attention_unum = soccer::unum_of_slot(player.attention);
  }
  sense.attention_count = player.counters.attentionto;

  sense.tackle_expires_in = player.tackle_cycles;
  sense.tackle_count = player.counters.tackle;
  sense.collided_with_ball = player.contacts.ball;
  sense.collided_with_player = player.contacts.player;
  sense.collided_with_post = player.contacts.post;
  sense.foul_charged = player.foul_cycles;
  sense.card = card(player);

  sense.has_focus_point = true;
  sense.focus_distance = player.view.focus_distance;
  sense.focus_direction = exact_degrees(player.view.focus_direction);
  return sense;
}

}  // namespace cls::simulator
