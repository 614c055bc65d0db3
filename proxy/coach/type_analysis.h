// Which player types the opponents have: found out by watching them run.
#pragma once

#include <array>

#include "proxy/perception/player_types_message.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// A step moves a player by the very velocity of which the server then keeps the share
/// `player_decay`, noise and wind included. A coach sees place and velocity without noise, so each
/// step of a free run tells the decay to about four digits, which few types share.
class TypeAnalysis {
 public:
  TypeAnalysis() { types_.fill(-1); }

  /// Takes in a view; moments of a standing clock teach nothing.
  void look(const WorldModel& world);
  /// The opponent of that number is another one from now on.
  void forget(int unum);

  /// By unum - 1, for players whose type was changed; -1: not known yet, or two types too alike.
  const TypeIds& found() const { return types_; }

 private:
  struct Track {
    int cycle = -1;
    soccer::Vec2 position;
    double kept = 0.0;   ///< sums over the steps: way times velocity kept,
    double moved = 0.0;  ///< and way squared
  };

  void add_step(const MatchParameters& parameters, Track& track, soccer::Vec2 way,
                soccer::Vec2 velocity);
  static int type_by(const MatchParameters& parameters, const Track& track);

  std::array<Track, soccer::kPlayersPerTeam> tracks_{};
  TypeIds types_{};
};

}  // namespace cls::proxy
