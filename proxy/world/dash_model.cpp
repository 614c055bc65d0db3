// Direction rate of dashes and the stamina rules.
#include "proxy/world/dash_model.h"

#include <algorithm>
#include <cmath>

namespace cls::proxy {

double dash_direction_rate(const soccer::ServerParams& server, double direction) {
  const double d = std::fabs(direction);
  const double rate =
      d > 90.0 ? server.back_dash_rate -
                     (server.back_dash_rate - server.side_dash_rate) * (1.0 - (d - 90.0) / 90.0)
               : server.side_dash_rate + (1.0 - server.side_dash_rate) * (1.0 - d / 90.0);
  return std::clamp(rate, 0.0, 1.0);
}

double top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  return std::min(type.real_speed_max(server.max_dash_power), type.player_speed_max);
}

int cycles_to_top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  constexpr double kCloseEnough = 0.01;
  constexpr int kLongest = 50;
  const double top = top_speed(server, type) - kCloseEnough;
  const double push = server.max_dash_power * type.dash_power_rate * type.effort_max;
  double speed = 0.0;
  int cycles = 0;
  while (speed < top && cycles < kLongest) {
    speed = speed * type.player_decay + push;
    ++cycles;
  }
  return cycles;
}

void Stamina::step(const soccer::ServerParams& server, const soccer::PlayerType& type,
                   double cost) {
  stamina = std::max(0.0, stamina - cost);
  if (stamina <= server.recover_dec_thr * server.stamina_max) {
    recovery = std::max(server.recover_min, recovery - server.recover_dec);
  }
  if (stamina <= server.effort_dec_thr * server.stamina_max) {
    effort = std::max(type.effort_min, effort - server.effort_dec);
  }
  if (stamina >= server.effort_inc_thr * server.stamina_max) {
    effort = std::min(type.effort_max, effort + server.effort_inc);
  }
  double gain = std::min(recovery * type.stamina_inc_max, server.stamina_max - stamina);
  if (server.stamina_capacity >= 0.0) {
    gain = std::min(gain, capacity);
    capacity = std::max(0.0, capacity - gain);
  }
  stamina = std::min(stamina + gain, server.stamina_max);
}

}  // namespace cls::proxy
