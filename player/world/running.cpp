// Simulates dashes and stamina by the server's rules.
#include "player/world/running.h"

#include <algorithm>
#include <cmath>

namespace cls::player {

double dash_rate(const soccer::ServerParams& server, double direction) {
  const double off = std::fabs(math::normalize_degrees(direction));
  const double rate =
      off <= 90.0 ? server.side_dash_rate + (1.0 - server.side_dash_rate) * (1.0 - off / 90.0)
                  : server.back_dash_rate - (server.back_dash_rate - server.side_dash_rate) *
                                                (1.0 - (off - 90.0) / 90.0);
  return std::clamp(rate, 0.0, 1.0);
}

LegPushes::LegPushes(const soccer::ServerParams& server) {
  constexpr double kSideways = 1e-3;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double direction = static_cast<double>(i) * kStep;
    push[i] = soccer::polar_degrees(dash_rate(server, direction), direction);
    per_forward[i] = std::fabs(push[i].x) < kSideways ? 0.0 : 1.0 / push[i].x;
  }
}

double top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  return std::min(type.real_speed_max(server.max_dash_power), type.player_speed_max);
}

int cycles_to_top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  constexpr double kCloseEnough = 0.01;
  constexpr int kMaxCycles = 50;
  const double top = top_speed(server, type) - kCloseEnough;
  const double push = server.max_dash_power * type.dash_power_rate * type.effort_max;

  double speed = 0.0;
  int cycles = 0;

  while (speed < top && cycles < kMaxCycles) {
    speed = speed * type.player_decay + push;
    ++cycles;
  }

  return cycles;
}

int cycles_to_run(const soccer::ServerParams& server, const soccer::PlayerType& type,
                  double distance) {
  const double acceleration = std::min(
      server.max_dash_power * type.dash_power_rate * type.effort_max, server.player_accel_max);

  double speed = 0.0;
  int cycles = 0;
  // After ten cycles the speed is constant; the rest is a division.
  for (; distance > 0.0 && cycles < 10; ++cycles) {
    speed = std::min(speed + acceleration, type.player_speed_max);
    distance -= speed;
    speed *= type.player_decay;
  }

  if (distance <= 0.0) return cycles;
  const double settled = std::min(speed + acceleration, type.player_speed_max);
  // Players of a faulty server may not get anywhere.
  constexpr double kForever = 1e6;
  const double rest = std::min(distance, 1000.0) / settled;
  return cycles + static_cast<int>(std::ceil(rest >= 0.0 && rest < kForever ? rest : kForever));
}

ReachTable::ReachTable(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  const double push = std::min(server.max_dash_power * type.dash_power_rate * type.effort_max,
                               server.player_accel_max);

  double speed = 0.0;
  for (std::size_t cycle = 1; cycle < run_.size(); ++cycle) {
    // Players of a faulty server may run backwards.
    speed = std::max(0.0, std::min(speed * type.player_decay + push, type.player_speed_max));
    run_[cycle] = run_[cycle - 1] + speed;
  }

  settled_speed_ = speed;
}

int ReachTable::cycles(double distance) const {
  if (distance <= 0.0) return 0;
  // Lower bound: constant terminal speed. Neither of the two need be a number.
  const double least = distance / settled_speed_;
  std::size_t cycle = least < kCycles ? static_cast<std::size_t>(least) : kCycles;
  while (cycle < run_.size() && run_[cycle] < distance) ++cycle;
  return static_cast<int>(cycle);
}

FullRun::FullRun(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  top_speed = player::top_speed(server, type);
  const double push = server.max_dash_power * type.dash_power_rate * type.effort_max;

  double speed = 0.0;
  double fading = 1.0;
  for (std::size_t n = 1; n <= kCycles; ++n) {
    speed = std::min(speed + push, type.player_speed_max);
    distance[n] = distance[n - 1] + speed;
    drift[n] = drift[n - 1] + fading;
    speed *= type.player_decay;
    fading *= type.player_decay;
  }
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

}  // namespace cls::player
