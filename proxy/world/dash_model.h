// How dashing moves a player and what it costs, as the server reckons.
#pragma once

#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

/// Share of a dash's power that acts in `direction` degrees relative to the body (simulation
/// model 4.3).
double dash_direction_rate(const soccer::ServerParams& server, double direction);

/// Speed that full dashes settle at, with full effort; metres per cycle.
double top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type);

/// Full dashes from rest until top speed is reached but for a centimetre per cycle.
int cycles_to_top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type);

/// A player's strength, followed over the cycles (simulation model 5).
struct Stamina {
  double stamina = 0.0;
  double effort = 1.0;
  double recovery = 1.0;
  double capacity = -1.0;

  /// One cycle in which `cost` of it is spent.
  void step(const soccer::ServerParams& server, const soccer::PlayerType& type, double cost);
};

}  // namespace cls::proxy
