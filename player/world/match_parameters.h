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
  std::vector<FullRun> full_runs;         ///< of `types`
  DistanceTable landmark_distances;       ///< for landmarks (quantize_step_l)
  DistanceTable object_distances;         ///< for ball and players (quantize_step)
  LegPushes leg_pushes;

  /// Defaults of rcssserver 19.
  MatchParameters()
      : types{soccer::default_player_type(server)},
        full_runs{FullRun(server, types.front())},
        landmark_distances(server.quantize_step_l),
        object_distances(server.quantize_step),
        leg_pushes(server) {}

  /// Type by id; the default type for unknown ids (and for -1).
  const soccer::PlayerType& type(int id) const { return types[index(id, types.size())]; }
  const FullRun& full_run(int id) const { return full_runs[index(id, full_runs.size())]; }

  /// `id` is not negative.
  void set_type(int id, const soccer::PlayerType& type) {
    const auto i = static_cast<std::size_t>(id);
    while (types.size() <= i) types.push_back(types.front());
    while (full_runs.size() <= i) full_runs.push_back(full_runs.front());
    types[i] = type;
    full_runs[i] = FullRun(server, type);
  }

 private:
  static std::size_t index(int id, std::size_t size) {
    return id >= 0 && static_cast<std::size_t>(id) < size ? static_cast<std::size_t>(id) : 0U;
  }
};

}  // namespace cls::player
