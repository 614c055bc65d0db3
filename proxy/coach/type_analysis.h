// Identifies the opponents' player types from their movement.
#pragma once

#include <array>

#include "player/perception/player_types_message.h"
#include "player/world/world_model.h"

namespace cls::proxy {

/// In a step the server moves a player by its velocity, noise and wind included, then multiplies
/// the velocity by `player_decay`. A coach sees positions and velocities without noise, so each
/// free movement gives the decay to about four digits, which few types share.
class TypeAnalysis {
 public:
  TypeAnalysis() { types_.fill(-1); }

  /// Evaluates a view; ignored while the clock is stopped.
  void update(const player::WorldModel& world);
  /// The opponent with that uniform number was substituted.
  void forget(int unum);

  /// By unum - 1, for players whose type was changed; -1: unknown or ambiguous.
  const player::TypeIds& found() const { return types_; }

 private:
  struct Track {
    int cycle = -1;
    soccer::Vec2 position;
    double weighted_decay = 0.0;  ///< sum over steps: decay times squared movement
    double weight = 0.0;          ///< sum over steps: squared movement
  };

  void add_step(const player::MatchParameters& parameters, Track& track, soccer::Vec2 movement,
                soccer::Vec2 velocity);
  static int type_by(const player::MatchParameters& parameters, const Track& track);

  std::array<Track, soccer::kPlayersPerTeam> tracks_{};
  player::TypeIds types_{};
};

}  // namespace cls::proxy
