// Parameters announced by the server; shared by all copies of a world model.
#pragma once

#include <vector>

#include "player/world/running.h"
#include "player/world/seen_distance.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::player {

struct MatchParameters {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;  ///< by id; gaps filled with the default type
  DistanceTable landmark_distances;       ///< for landmarks (quantize_step_l)
  DistanceTable object_distances;         ///< for ball and players (quantize_step)
  LegPushes leg_pushes;

  /// Defaults of rcssserver 19.
  MatchParameters()
      : types{soccer::default_player_type(server)},
        landmark_distances(server.quantize_step_l),
        object_distances(server.quantize_step),
        leg_pushes(server) {}

  /// Type by id; the default type for unknown ids (and for -1).
  const soccer::PlayerType& type(int id) const {
    return types[id >= 0 && static_cast<std::size_t>(id) < types.size()
                     ? static_cast<std::size_t>(id)
                     : 0U];
  }
};

}  // namespace cls::player
