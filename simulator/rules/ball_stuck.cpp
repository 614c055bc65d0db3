// Ball stuck rule: drop ball after the ball stays in one area too long
// (docs/spec/simulation-model.md 9.12).
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void analyze(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  if (server.ball_stuck_area <= 0.0 || server.drop_ball_time <= 0) return;
  BallStuckState& state = world.referee.ball_stuck;
  const bool stuck = distance(world.ball.position, state.reference) <= server.ball_stuck_area;
  if (world.mode != PlayMode::kPlayOn || !stuck) {
    state = {world.ball.position, 0};
    return;
  }
  if (++state.counter < server.drop_ball_time) return;
  state = {world.ball.position, 0};
  drop_ball(world, events);
}

}  // namespace

const Rule kBallStuckRule = {.analyze = analyze};

}  // namespace cls::simulator
