// Simulates the ball and full dashes from rest.
#include "player/movement/ball_race.h"

#include <algorithm>
#include <cmath>

#include "soccer/pitch.h"

namespace cls::player {

using soccer::Vec2;

BallRace::BallRace(const WorldModel& world, bool foul) : world_(world) {
  const soccer::ServerParams& server = world.server();
  add(world.self_type(), {world.self.position, 0.0, foul ? 1 : server.tackle_cycles, true, 0});
  add_others(world.teammates, true, false);
  add_others(world.opponents, false, foul);
}

void BallRace::add(const soccer::PlayerType& type, Runner runner) {
  const auto known = std::find(types_.begin(), types_.end(), &type);
  runner.delay = std::max(0, runner.delay);
  runner.type = static_cast<std::size_t>(known - types_.begin());

  if (known == types_.end()) {
    types_.push_back(&type);
    reach_.push_back(ReachTable(world_.server(), type));
  }

  runner.control = type.kickable_area(world_.server().ball_size);
  runners_.push_back(runner);
}

void BallRace::add_others(const PlayerList& players, bool ours, bool foul) {
  constexpr int kMaxAge = 15;
  const soccer::ServerParams& server = world_.server();
  for (const PlayerState& player : players) {
    if (player.ghost() || player.pos_count > kMaxAge || runners_.full()) continue;
    if (ours && player.goalie) continue;  // must not catch the ball

    const soccer::PlayerType& type = world_.type_of(player);
    const bool fouled = foul && player.dist_from_ball < type.kickable_area(server.ball_size);
    const int delay = player.tackling ? server.tackle_cycles / 2 : fouled ? server.foul_cycles : 0;
    add(type, {player.position, 0.0, delay, ours, 0});
  }
}

bool BallRace::gets_ball(const Runner& runner, Vec2 ball, int cycle) const {
  if (cycle < runner.delay) return false;
  const double far = runner.control + reach_[runner.type].run(cycle - runner.delay);
  return (ball - runner.from).squared_length() <= far * far;
}

RaceResult BallRace::run(Vec2 velocity) const {
  constexpr int kHorizon = 20;
  RaceResult result{kHorizon, kHorizon};
  Vec2 ball = world_.ball.position;

  for (int cycle = 1; cycle < kHorizon; ++cycle) {
    ball += velocity;
    velocity *= world_.server().ball_decay;
    if (std::fabs(ball.x) > soccer::kHalfLength || std::fabs(ball.y) > soccer::kHalfWidth) break;
    for (const Runner& runner : runners_) {
      int& first = runner.ours ? result.ours : result.theirs;
      if (first == kHorizon && gets_ball(runner, ball, cycle)) first = cycle;
    }
    if (result.ours < kHorizon && result.theirs < kHorizon) break;
  }

  return result;
}

}  // namespace cls::player
