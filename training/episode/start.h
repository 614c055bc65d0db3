// Where an episode starts if not at the places of its task: a situation of a book, or a state that
// the caller gives.
#pragma once

#include <array>
#include <vector>

#include "analysis/situations/book.h"
#include "simulator/world/event.h"
#include "training/scene/cast.h"

namespace cls::training {

/// Meters, meters per cycle and radians in server coordinates; `neck` relative to the body.
struct StartPlayer {
  bool on_pitch = true;
  int type = -1;  ///< -1: as it is
  Vec2 position;
  Vec2 velocity;
  double body = 0.0;
  double neck = 0.0;
  simulator::Stamina stamina{};  ///< a negative capacity: as it is
  int tackle_cycles = 0;
  int foul_cycles = 0;
  int catch_ban = 0;
  int cards = 0;
};

struct StartFrame {
  Vec2 ball;
  Vec2 ball_velocity;
  std::array<StartPlayer, soccer::kPlayersOnPitch> players;  ///< by slot; others than the cast's
                                                             ///< have no meaning
};

struct Start {
  soccer::PlayMode mode = soccer::PlayMode::kPlayOn;
  int cycles = 0;  ///< of the episode
  int time = 0;    ///< of the match clock
  std::array<int, 2> score = {};
  int last_touch = simulator::kNoPlayer;
  int catcher = simulator::kNoPlayer;
  /// The steps before the moment, which those who perceive have seen, and the moment last.
  std::vector<StartFrame> frames;
};

/// The situation, at time and score 0.
Start start_of(const analysis::Situation& situation);

/// Puts the world of a new episode into the mode, with the first or the last frame.
void begin_at(const Start& start, const StartFrame& frame, const Cast& cast,
              simulator::World& world, simulator::Events& events);

/// Puts ball and players of the cast where they are in the frame.
void show(const StartFrame& frame, const Cast& cast, simulator::World& world);

}  // namespace cls::training
