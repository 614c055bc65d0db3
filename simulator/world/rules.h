// Constants of a match: parameters, player types and derived lengths.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::simulator {

/// Maximum of player::player_types (rcssserver default: 18).
constexpr int kMaxPlayerTypes = 128;

/// Immutable; shared by all copies of a World.
struct Rules {
  soccer::ServerParams server;
  soccer::PlayerParams player;  ///< random_seed is the seed of the player types
  std::vector<soccer::PlayerType> types;

  // In cycles.
  int half_time = 0;
  int extra_half_time = 0;
  int normal_time = 0;  ///< end of the normal halves
  int total_time = 0;   ///< end of the extra halves

  /// Without a referee no rule is applied and the play mode never changes automatically.
  bool has_referee() const { return !server.coach || server.coach_w_referee; }
};

/// Validates the parameters and draws the player types from player.random_seed, or from `seed` if
/// that is negative. The error names the invalid parameter.
base::Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                      soccer::PlayerParams player,
                                                      std::uint64_t seed);

/// Same with given player types, such as those of a recorded match.
base::Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                      const soccer::PlayerParams& player,
                                                      std::vector<soccer::PlayerType> types);

}  // namespace cls::simulator
