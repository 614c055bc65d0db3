// One random stream per purpose, so that a draw in one place never shifts another.
#pragma once

#include <array>
#include <cstdint>

#include "soccer/random.h"
#include "soccer/side.h"

namespace cls::simulator {

using soccer::RandomStream;
using PlayerStreams = std::array<RandomStream, soccer::kPlayersOnPitch>;

/// The draws of the world itself. Whoever drives it (order of commands, senses) makes its own
/// streams from World::seed.
struct RandomStreams {
  explicit RandomStreams(std::uint64_t seed = 0);

  RandomStream ball_motion;
  PlayerStreams player_motion;
  PlayerStreams turn;  ///< turns and the rotation of dashes
  PlayerStreams kick_noise;
  PlayerStreams tackle;  ///< does it succeed
  PlayerStreams tackle_noise;
  PlayerStreams catch_ball;
  PlayerStreams foul;      ///< by tackler
  RandomStream collision;  ///< directions of exact coincidences
  RandomStream placement;  ///< where the referee puts players
  RandomStream shoot_out;  ///< goal, first taker, coin toss
};

}  // namespace cls::simulator
