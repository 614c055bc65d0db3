// Commands of trainers, and of monitors: the human referee.
#include "simulator/actions/trainer.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "simulator/referee/areas.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/collision.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"
#include "simulator/world/stamina.h"
#include "soccer/interval.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

// Behind the goal line, between the posts, no deeper than the net.
bool is_in_goal_box(const World& world, double end) {
  const soccer::ServerParams& server = world.params();
  const double center = (soccer::kPitchLength + soccer::kGoalDepth) / 2.0 + server.ball_size;
  return soccer::Rect::centered({center * end, 0.0}, soccer::kGoalDepth,
                                server.goal_width + soccer::kGoalPostRadius)
      .contains(world.ball.position);
}

// Limits positions and velocities, because squares of huge numbers are infinite.
Vec2 limited(Vec2 v) {
  constexpr double kMax = 1e6;
  return {std::clamp(v.x, -kMax, kMax), std::clamp(v.y, -kMax, kMax)};
}

using Reply = std::optional<soccer::ServerReply>;

/// One overload per command that reads or changes the world.
struct Executor {
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
  // Players that are not connected are moved too. A player of an unknown team gets an ok reply.
  Reply operator()(const soccer::MovePlayer& command) {
    const Side side = find_side(world, command.team);
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
    return soccer::OkCheckBall{world.clock.time, locate_ball(world)};
  }
  Reply operator()(const soccer::TrainerChangePlayerType& command) {
    return change_type(world, command, events);
  }
  template <typename Other>
  Reply operator()(const Other&) {
    return std::nullopt;
  }
};

struct MonitorExecutor {
  World& world;
  Events& events;

  void operator()(const soccer::DispStart&) const { kick_off(world, events); }

  void operator()(const soccer::DispFoul& foul) const {
    if (foul.side == Side::kNeutral) return drop_ball(world, clamp_to_pitch(foul.position), events);
    if (soccer::is_penalty_mode(world.mode)) return;
    announce(world, {"foul", opponent(foul.side)}, events);
    world.ball_catcher = kNoPlayer;
    place_ball(world, for_side(PlayMode::kFreeKickLeft, foul.side), foul.side,
               clamp_to_pitch(foul.position), events);
    keep_players_in_field(world);
    world.ball_catcher = kNoPlayer;
  }

  void operator()(const soccer::DispPlayer& placed) const {
    if (placed.side == Side::kNeutral) return;
    Player& player = world.player(placed.side, placed.unum);
    player.position = placed.position;
    player.velocity = {};
    player.body = exact_radians(placed.body);  // not clamped, unlike a trainer's
    player.pending_body = player.body;
    resolve_collisions(world, events);
  }

  void operator()(const soccer::DispDiscard& discard) const {
    if (discard.side == Side::kNeutral) return;
    Player& player = world.player(discard.side, discard.unum);
    if (!player.enabled) return;
    leave(world, player.slot());
    player.state |= state::kDiscard;
    report(events, world, SentOff{player.slot()});
  }

  void operator()(const soccer::DispCard& card) const {
    if (card.side == Side::kNeutral) return;
    Player& player = world.player(card.side, card.unum);
    if (!player.enabled) return;
    if (card.red) {
      show_red_card(world, player, events);
    } else {
      show_yellow_card(world, player, events);
    }
  }

  void operator()(const soccer::DispBye&) const {}
  void operator()(const soccer::Compression&) const {}
};

}  // namespace

Reply apply(World& world, const soccer::CoachCommand& command, Events& events) {
  return std::visit(Executor{world, events}, command);
}

void apply(World& world, const soccer::MonitorCommand& command, Events& events) {
  std::visit(MonitorExecutor{world, events}, command);
}

void move_ball(World& world, Vec2 position, Vec2 velocity) {
  world.ball_catcher = kNoPlayer;
  world.ball = {limited(position), limited(velocity), {}};
}

void move_player(World& world, Slot slot, Vec2 position, std::optional<double> body_degrees,
                 std::optional<Vec2> velocity, Events& events) {
  Player& player = world.player(slot);
  player.position = limited(position);

  if (body_degrees) {
    const soccer::ServerParams& server = world.params();
    player.body = exact_radians(soccer::between(*body_degrees, server.minmoment, server.maxmoment));
  }

  player.pending_body = player.body;  // discards a turn of this cycle
  if (velocity) player.velocity = limited(*velocity);
  resolve_collisions(world, events);
}

soccer::BallPlace locate_ball(const World& world) {
  if (is_in_goal_box(world, -1.0)) return soccer::BallPlace::kGoalLeft;
  if (is_in_goal_box(world, 1.0)) return soccer::BallPlace::kGoalRight;

  const double margin = world.params().ball_size;
  const bool is_out = std::fabs(world.ball.position.x) > soccer::kHalfLength + margin ||
                      std::fabs(world.ball.position.y) > soccer::kHalfWidth + margin;
  return is_out ? soccer::BallPlace::kOutOfField : soccer::BallPlace::kInField;
}

}  // namespace cls::simulator
