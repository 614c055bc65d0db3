// Moving things by hand.
#include "simulator/actions/trainer.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "simulator/referee/collision.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"
#include "simulator/world/stamina.h"
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

// Farther and faster there is nothing to see, and squares of numbers without end are no numbers.
Vec2 limited(Vec2 wished) {
  constexpr double kMost = 1e6;
  return {std::clamp(wished.x, -kMost, kMost), std::clamp(wished.y, -kMost, kMost)};
}

using Reply = std::optional<soccer::ServerReply>;

/// One overload per command that changes or asks the world.
struct Obedience {
  World& world;
  Events& events;

  Reply operator()(const soccer::Start&) {
    kick_off(world, events);
    return soccer::OkStart{};
  }
  Reply operator()(const soccer::ChangeMode& command) {
    change_mode(world, command.mode, events);
    return soccer::OkChangeMode{};
  }
  Reply operator()(const soccer::MoveBall& command) {
    move_ball(world, command.position, command.velocity.value_or(Vec2{}));
    return soccer::OkMove{};
  }
  // A player who is not there is moved as well; one of an unknown team is said to be.
  Reply operator()(const soccer::MovePlayer& command) {
    const Side side = side_called(world, command.team);
    if (side != Side::kNeutral) {
      move_player(world, soccer::slot_of(side, command.unum), command.position, command.angle,
                  command.velocity, events);
    }
    return soccer::OkMove{};
  }
  Reply operator()(const soccer::Recover&) {
    recover_all(world);
    return soccer::OkRecover{};
  }
  Reply operator()(const soccer::CheckBall&) {
    return soccer::OkCheckBall{world.clock.time, ball_place(world)};
  }
  Reply operator()(const soccer::TrainerChangePlayerType& command) {
    return change_type(world, command, events);
  }
  template <typename Other>
  Reply operator()(const Other&) {
    return std::nullopt;
  }
};

}  // namespace

Reply obey(World& world, const soccer::CoachCommand& command, Events& events) {
  return std::visit(Obedience{world, events}, command);
}

void move_ball(World& world, Vec2 position, Vec2 velocity) {
  world.ball_catcher = kNobody;
  world.ball = {limited(position), limited(velocity), {}};
}

void move_player(World& world, Slot slot, Vec2 position, std::optional<double> body_degrees,
                 std::optional<Vec2> velocity, Events& events) {
  Player& player = world.player(slot);
  player.position = limited(position);
  if (body_degrees) {
    const soccer::ServerParams& server = world.params();
    player.body = exact_radians(std::clamp(*body_degrees, server.minmoment, server.maxmoment));
  }
  player.pending_body = player.body;  // a turn of this cycle is forgotten
  if (velocity) player.velocity = limited(*velocity);
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
