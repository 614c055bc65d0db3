// Estimates the stamina of the own players from their movement and their say messages, since the
// server does not send it to coaches.
#pragma once

#include <array>
#include <string_view>

#include "base/index.h"
#include "player/world/running.h"
#include "player/world/world_model.h"

namespace cls::proxy {

class StaminaEstimate {
 public:
  /// Estimates the dash power behind each movement since the last view.
  void update(const player::WorldModel& world);
  /// Reads stamina values from an own player's say message; ignores other content.
  void hear(const player::WorldModel& world, int unum, std::string_view text);
  /// A fresh player has that uniform number now.
  void replace(const player::WorldModel& world, int unum);

  const player::Stamina& of(int unum) const { return tracks_[base::index(unum - 1)].stamina; }

 private:
  struct Track {
    int cycle = -1;  ///< of the last view; -1: none yet
    soccer::Vec2 position;
    soccer::Vec2 velocity;
    double power = 0.0;  ///< of the last recognized dash
    player::Stamina stamina;
  };

  static double dash_power(const player::WorldModel& world, const player::PlayerState& player,
                           const Track& before);

  Track& track(int unum) { return tracks_[base::index(unum - 1)]; }

  std::array<Track, soccer::kPlayersPerTeam> tracks_{};
};

}  // namespace cls::proxy
