// What stays the same during a match: parameters, player types and what follows from them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::simulator {

/// More types than this are refused (rcssserver plays with 18).
constexpr int kMaxPlayerTypes = 128;

/// Parameters of a match. Worlds share one object and never change it.
struct Rules {
  soccer::ServerParams server;
  soccer::PlayerParams player;  ///< random_seed is the seed that the types were drawn with
  std::vector<soccer::PlayerType> types;

  // In cycles, so that no step has to convert seconds.
  int half_time = 0;
  int extra_half_time = 0;
  int normal_time = 0;  ///< end of the normal halves
  int total_time = 0;   ///< end of the extra halves

  /// With a trainer and without referees no rule is applied and no mode changes by itself.
  bool has_referee() const { return !server.coach || server.coach_w_referee; }
};

/// Checks the parameters and draws the player types from player.random_seed, or, when that is
/// negative, from `seed`. The error names the parameter that makes no match.
base::Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                      soccer::PlayerParams player,
                                                      std::uint64_t seed);

/// The same with types that are known already, as those of a recorded match.
base::Result<std::shared_ptr<const Rules>> make_rules(const soccer::ServerParams& server,
                                                      const soccer::PlayerParams& player,
                                                      std::vector<soccer::PlayerType> types);

}  // namespace cls::simulator
