// One random stream per purpose, so that a draw for one purpose never shifts another.
#pragma once

#include <array>
#include <cstdint>

#include "soccer/random.h"
#include "soccer/side.h"

namespace cls::simulator {

using soccer::RandomStream;
using PlayerStreams = std::array<RandomStream, soccer::kPlayersOnPitch>;

/// Streams of the simulation itself. The server derives its own streams (order of commands, senses)
/// from World::seed.
struct RandomStreams {
  explicit RandomStreams(std::uint64_t seed = 0);

  RandomStream ball_motion;
  PlayerStreams player_motion;
  PlayerStreams turn;  ///< turns, and rotation by dashes
  PlayerStreams kick_noise;
  PlayerStreams tackle;  ///< success
  PlayerStreams tackle_noise;
  PlayerStreams catch_ball;
  PlayerStreams foul;      ///< indexed by tackler
  RandomStream collision;  ///< directions for objects at the same position
  RandomStream placement;  ///< random positions chosen by the referee
  RandomStream shoot_out;  ///< goal, first taker, coin toss
};

}  // namespace cls::simulator
