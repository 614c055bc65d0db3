// The parameters a server announces: the same for the whole match, shared by all copies of a world.
#pragma once

#include <vector>

#include "proxy/world/seen_distance.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

struct MatchParameters {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;  ///< by id; filled up with the default type
  DistanceTable landmark_distances;       ///< for what server.quantize_step_l rounds
  DistanceTable object_distances;         ///< for what server.quantize_step rounds

  /// The defaults of rcssserver 19.
  MatchParameters();

  /// The type of that id; the default type for an id that was never announced (and for -1).
  const soccer::PlayerType& type(int id) const {
    return types[id >= 0 && static_cast<std::size_t>(id) < types.size()
                     ? static_cast<std::size_t>(id)
                     : 0U];
  }
};

}  // namespace cls::proxy
