// The facts of a State that the example team's decisions begin with.
#pragma once

#include <vector>

#include "proto/playmaker.pb.h"
#include "soccer/geometry.h"

namespace cls::mock_server::example {

/// Meters or cycles: no player is there.
constexpr double kFar = 1000;

/// The opponent's goal: every team attacks toward +x.
constexpr soccer::Vec2 kGoal{52.5, 0};

/// The State of one player. It refers to the State, which must live longer.
struct Situation {
  const protos::WorldModel* world = nullptr;
  const protos::Self* self = nullptr;
  soccer::Vec2 me;
  soccer::Vec2 ball;
  std::vector<soccer::Vec2> opponents;  // of at most 20 cycles ago

  // Cycles to the ball: of this player, its fastest teammate, the fastest opponent.
  int my_steps = 0;
  int our_steps = 0;
  int their_steps = 0;
};

Situation situation_of(const protos::WorldModel& world);

/// A position or velocity of the State.
soccer::Vec2 point_of(const protos::RpcVector2D& vector);

/// Distance of the nearest opponent, kFar without one.
double room(const Situation& now, soccer::Vec2 place);

/// How far opponents stay away from a ball that rolls from start to end; below 0 they reach it. An
/// opponent reaches 0.8 m, and 0.2 m more for each meter that the ball rolls.
double lane(const Situation& now, soccer::Vec2 start, soccer::Vec2 end);

}  // namespace cls::mock_server::example
