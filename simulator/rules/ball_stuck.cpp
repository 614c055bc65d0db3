// Ball stuck: a ball that stays in one place too long is dropped (9.12).
#include "simulator/referee/calls.h"
#include "simulator/referee/rule.h"

namespace cls::simulator {
namespace {

void analyse(World& world, Events& events) {
  const soccer::ServerParams& server = world.params();
  if (server.ball_stuck_area <= 0.0 || server.drop_ball_time <= 0) return;
  BallStuckRule& memory = world.referee.ball_stuck;
  const bool stays = distance(world.ball.position, memory.reference) <= server.ball_stuck_area;
  if (world.mode != PlayMode::kPlayOn || !stays) {
    memory = {world.ball.position, 0};
    return;
  }
  if (++memory.counter < server.drop_ball_time) return;
  memory = {world.ball.position, 0};
  drop_ball(world, events);
}

}  // namespace

const Rule kBallStuckRule = {.analyse = analyse};

}  // namespace cls::simulator
