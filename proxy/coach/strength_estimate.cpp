// Ways into dashes, dashes into strength.
#include "proxy/coach/strength_estimate.h"

#include <algorithm>
#include <variant>

#include "proxy/perception/say_message.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

Stamina fresh(const WorldModel& world, int unum) {
  const auto& types = world.our_types;
  const soccer::PlayerType& type =
      world.parameters->type(types[static_cast<std::size_t>(unum - 1)]);
  const soccer::ServerParams& server = world.server();
  return {server.stamina_max, type.effort_max, server.recover_init, server.stamina_capacity};
}

}  // namespace

void StrengthEstimate::replace(const WorldModel& world, int unum) {
  track(unum).strength = fresh(world, unum);
}

// The power of the dash that made this way out of the velocity before. Noise is up to player_rand
// of the speed; what is below that is taken for coasting. A way that the new velocity does not
// follow from ended in a collision: the player is taken to have gone on as before.
double StrengthEstimate::dash_power(const WorldModel& world, const PlayerState& player,
                                    const Track& before) {
  constexpr double kCollided = 0.02;  // metres per cycle
  constexpr double kPlausible = 1.5;  // beyond that somebody moved the player
  const soccer::ServerParams& server = world.server();
  const soccer::PlayerType& type = world.type_of(player);
  const Vec2 way = player.position - before.position;
  if (soccer::distance(way * type.player_decay, player.velocity) > kCollided) return before.power;
  const Vec2 push = way - before.velocity;
  if (push.length() <= server.player_rand * way.length()) return 0.0;
  const double direction = (soccer::AngleDeg::of(push) - player.body).degrees();
  const double rate = std::max(0.1, dash_direction_rate(server, direction));
  const double power = push.length() / (rate * type.dash_power_rate * before.strength.effort);
  return power > kPlausible * server.max_dash_power ? 0.0 : std::min(power, server.max_dash_power);
}

void StrengthEstimate::look(const WorldModel& world) {
  const int now = world.game.time.cycle;
  // Before each half of normal time all rest.
  const bool rest = world.game.mode == soccer::PlayMode::kBeforeKickOff &&
                    now < world.server().normal_time_cycles();
  for (const PlayerState& mate : world.teammates) {
    Track& one = track(mate.unum);
    if (rest || one.cycle < 0) {
      replace(world, mate.unum);
    } else {
      one.power = now == one.cycle + 1 ? dash_power(world, mate, one) : 0.0;
      one.strength.step(world.server(), world.type_of(mate), one.power);
    }
    one.cycle = now;
    one.position = mate.position;
    one.velocity = mate.velocity;
  }
}

void StrengthEstimate::hear(const WorldModel& world, int unum, std::string_view text) {
  const soccer::ServerParams& server = world.server();
  Stamina& strength = track(unum).strength;
  while (const auto said = take_say_message(text, server)) {
    if (const auto* stamina = std::get_if<SayStamina>(&*said)) {
      strength.stamina = stamina->fraction * server.stamina_max;
    } else if (const auto* recovery = std::get_if<SayRecovery>(&*said)) {
      strength.recovery =
          server.recover_min + recovery->fraction * (server.recover_init - server.recover_min);
    } else if (const auto* capacity = std::get_if<SayCapacity>(&*said)) {
      if (server.stamina_capacity >= 0.0) {
        strength.capacity = capacity->fraction * server.stamina_capacity;
      }
    }
  }
}

}  // namespace cls::proxy
