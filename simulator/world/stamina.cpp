// Stamina model.
#include "simulator/world/stamina.h"

#include <algorithm>

namespace cls::simulator {

void update_stamina(const World& world, Player& player) {
  const soccer::ServerParams& server = world.params();
  const soccer::PlayerType& type = world.type_of(player);
  Stamina& stamina = player.stamina;

  if (stamina.value <= server.recover_dec_thr * server.stamina_max &&
      stamina.recovery > server.recover_min) {
    stamina.recovery = std::max(server.recover_min, stamina.recovery - server.recover_dec);
  }
  if (stamina.value <= server.effort_dec_thr * server.stamina_max &&
      stamina.effort > type.effort_min) {
    stamina.effort = std::max(type.effort_min, stamina.effort - server.effort_dec);
  }
  if (stamina.value >= server.effort_inc_thr * server.stamina_max &&
      stamina.effort < type.effort_max) {
    stamina.effort = std::min(type.effort_max, stamina.effort + server.effort_inc);
  }

  const bool limited = server.stamina_capacity >= 0.0;
  double gain =
      std::min(stamina.recovery * type.stamina_inc_max, server.stamina_max - stamina.value);
  if (limited) gain = std::min(gain, stamina.capacity);
  stamina.value = std::min(stamina.value + gain, server.stamina_max);
  if (limited) stamina.capacity = std::max(0.0, stamina.capacity - gain);
}

void recover(const World& world, Player& player) {
  const soccer::ServerParams& server = world.params();
  player.stamina = {server.stamina_max, world.type_of(player).effort_max, 1.0,
                    server.stamina_capacity};
  player.ears.teammate_capacity = server.hear_max;
  player.ears.opponent_capacity = server.hear_max;
}

void recover_all(World& world) {
  for (Player& player : world.players) {
    if (player.enabled) recover(world, player);
  }
}

}  // namespace cls::simulator
