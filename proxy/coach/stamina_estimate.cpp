// From movements to dashes, from dashes to stamina.
#include "proxy/coach/stamina_estimate.h"

#include <algorithm>
#include <variant>

#include "base/index.h"
#include "player/perception/say_message.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

player::Stamina fresh(const player::WorldModel& world, int unum) {
  const soccer::PlayerType& type = world.parameters->type(world.our_types[base::index(unum - 1)]);
  const soccer::ServerParams& server = world.server();
  return {server.stamina_max, type.effort_max, server.recover_init, server.stamina_capacity};
}

}  // namespace

void StaminaEstimate::replace(const player::WorldModel& world, int unum) {
  track(unum).stamina = fresh(world, unum);
}

// Power of the dash that explains the movement, given the velocity before. Noise is up to
// player_rand of the speed; a smaller difference counts as coasting. A movement that does not match
// the new velocity ended in a collision: assume the previous power.
double StaminaEstimate::dash_power(const player::WorldModel& world,
                                   const player::PlayerState& player, const Track& before) {
  constexpr double kCollided = 0.02;  // meters per cycle
  constexpr double kPlausible = 1.5;  // above it, a trainer moved the player
  const soccer::ServerParams& server = world.server();
  const soccer::PlayerType& type = world.type_of(player);

  const Vec2 movement = player.position - before.position;
  const Vec2 kept = movement * type.player_decay;
  if (soccer::distance(kept, player.velocity) > kCollided) return before.power;
  const Vec2 push = movement - before.velocity;
  if (push.length() <= server.player_rand * movement.length()) return 0.0;

  const double direction = (soccer::AngleDeg::of(push) - player.body).degrees();
  const double rate = std::max(0.1, player::dash_rate(server, direction));
  const double power = push.length() / (rate * type.dash_power_rate * before.stamina.effort);
  return power > kPlausible * server.max_dash_power ? 0.0 : std::min(power, server.max_dash_power);
}

void StaminaEstimate::update(const player::WorldModel& world) {
  const int now = world.game.time.cycle;
  // Stamina is reset before each half of normal time.
  const bool is_reset = world.game.mode == soccer::PlayMode::kBeforeKickOff &&
                        now < world.server().normal_time_cycles();

  for (const player::PlayerState& teammate : world.teammates) {
    Track& one = track(teammate.unum);
    if (is_reset || one.cycle < 0) {
      replace(world, teammate.unum);
    } else {
      one.power = now == one.cycle + 1 ? dash_power(world, teammate, one) : 0.0;
      one.stamina.step(world.server(), world.type_of(teammate), one.power);
    }
    one.cycle = now;
    one.position = teammate.position;
    one.velocity = teammate.velocity;
  }
}

void StaminaEstimate::hear(const player::WorldModel& world, int unum, std::string_view text) {
  const soccer::ServerParams& server = world.server();
  player::Stamina& estimate = track(unum).stamina;

  while (const auto said = player::parse_say_message(text, server)) {
    if (const auto* stamina = std::get_if<player::SayStamina>(&*said)) {
      estimate.stamina = stamina->fraction * server.stamina_max;
    } else if (const auto* recovery = std::get_if<player::SayRecovery>(&*said)) {
      estimate.recovery =
          server.recover_min + recovery->fraction * (server.recover_init - server.recover_min);
    } else if (const auto* capacity = std::get_if<player::SayCapacity>(&*said)) {
      if (server.stamina_capacity >= 0.0) {
        estimate.capacity = capacity->fraction * server.stamina_capacity;
      }
    }
  }
}

}  // namespace cls::proxy
