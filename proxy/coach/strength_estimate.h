// How much strength our players have left, as their coach can tell: from how they run and what they
// say. The server does not tell him.
#pragma once

#include <array>
#include <string_view>

#include "proxy/world/dash_model.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

class StrengthEstimate {
 public:
  /// Takes in a view: what each way of the cycle must have cost.
  void look(const WorldModel& world);
  /// Takes in what our player said aloud; what is no word about strength is passed over.
  void hear(const WorldModel& world, int unum, std::string_view text);
  /// A fresh player has that number now.
  void replace(const WorldModel& world, int unum);

  const Stamina& of(int unum) const { return tracks_[static_cast<std::size_t>(unum - 1)].strength; }

 private:
  struct Track {
    int cycle = -1;  ///< of the last view; -1: none yet
    soccer::Vec2 position;
    soccer::Vec2 velocity;
    double power = 0.0;  ///< of the last dash that could be told
    Stamina strength;
  };

  static double dash_power(const WorldModel& world, const PlayerState& player, const Track& before);

  Track& track(int unum) { return tracks_[static_cast<std::size_t>(unum - 1)]; }

  std::array<Track, soccer::kPlayersPerTeam> tracks_{};
};

}  // namespace cls::proxy
