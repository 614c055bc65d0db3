// Moving things by hand.
#include "simulator/trainer.h"

#include <algorithm>
#include <cmath>

#include "simulator/collision.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

// Behind the line, between the posts, no deeper than the net.
bool is_in_goal_box(const World& world, double end) {
  const soccer::ServerParams& server = world.params();
  const double centre = (soccer::kPitchLength + soccer::kGoalDepth) / 2.0 + server.ball_size;
  return soccer::Rect::centred({centre * end, 0.0}, soccer::kGoalDepth,
                               server.goal_width + soccer::kGoalPostRadius)
      .contains(world.ball.position);
}

}  // namespace

void move_ball(World& world, Vec2 position, Vec2 velocity) {
  world.ball_catcher = kNobody;
  world.ball = {position, velocity, {}};
}

void move_player(World& world, Slot slot, Vec2 position, std::optional<double> body_degrees,
                 std::optional<Vec2> velocity, Events& events) {
  Player& player = world.player(slot);
  player.position = position;
  if (body_degrees) {
    player.body = soccer::math::to_radians(std::clamp(*body_degrees, -180.0, 180.0));
    player.pending_body = player.body;
  }
  if (velocity) player.velocity = *velocity;
  resolve_collisions(world, events);
}

soccer::BallPlace ball_place(const World& world) {
  if (is_in_goal_box(world, -1.0)) return soccer::BallPlace::kGoalLeft;
  if (is_in_goal_box(world, 1.0)) return soccer::BallPlace::kGoalRight;
  const double margin = world.params().ball_size;
  const bool is_out = std::fabs(world.ball.position.x) > soccer::kHalfLength + margin ||
                      std::fabs(world.ball.position.y) > soccer::kHalfWidth + margin;
  return is_out ? soccer::BallPlace::kOutOfField : soccer::BallPlace::kInField;
}

}  // namespace cls::simulator
