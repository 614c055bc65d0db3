// Heterogeneous player types, and how the server draws them.
#pragma once

#include <cstdint>
#include <vector>

#include "soccer/parameters/parameter.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {

/// Diagonal of the pitch in meters, sqrt(105^2 + 68^2): the maximum view distance.
constexpr double kPitchDiagonal = 125.0959631642844;

/// One player type; members are named and ordered as in the player_type message.
struct PlayerType {
#define CLS_PLAYER_TYPE(type, name, value, since) type name = value;
#include "soccer/parameters/player_type.inc"
#undef CLS_PLAYER_TYPE

  /// Maximum distance of the centers at which the ball can be kicked.
  double kickable_area(double ball_size) const { return player_size + ball_size + kickable_margin; }

  /// Terminal speed of dashes with full power and effort.
  double real_speed_max(double max_power) const {
    return max_power * dash_power_rate * effort_max / (1.0 - player_decay);
  }
};

/// All rows in message order (not alphabetical, unlike the parameter messages).
const ParameterTable<PlayerType>& player_type_table();

/// Type 0, built from the server parameters.
PlayerType default_player_type(const ServerParams& server);

/// All types of a match: type 0 and player_types - 1 drawn ones, identical to those that rcssserver
/// 19 (libstdc++) draws from the same seed (docs/spec/simulation-model.md 6.1, 14.1).
std::vector<PlayerType> draw_player_types(const ServerParams& server, const PlayerParams& player,
                                          std::uint32_t seed);

}  // namespace cls::soccer
