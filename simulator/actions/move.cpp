// move: positions before kick-offs, and moves of the goalie with a caught ball
// (docs/spec/simulation-model.md 4.8).
#include "simulator/actions/commands.h"
#include "simulator/referee/collision.h"

namespace cls::simulator::actions {
namespace {

using soccer::ServerReply;

bool may_move_anywhere(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || mode == PlayMode::kGoalLeft ||
         mode == PlayMode::kGoalRight;
}

bool may_move_with_ball(const World& world, const Player& player) {
  return world.ball_catcher == player.slot() &&
         (world.mode == PlayMode::kFreeKickLeft || world.mode == PlayMode::kFreeKickRight);
}

// The move is executed; the referee moves the player back later.
std::optional<ServerReply> opponent_field_warning(const World& world, const Player& player,
                                                  double x) {
  if (world.mode != PlayMode::kBeforeKickOff || !world.params().forbid_kick_off_offside ||
      x < -world.type_of(player).player_size) {
    return std::nullopt;
  }
  return soccer::reply_of(soccer::WarningCode::kMovingToOpponentField);
}

bool has_move_left(const World& world, const Player& player) {
  const int max_moves = world.params().goalie_max_moves;
  return max_moves < 0 || player.moves_since_catch < max_moves;
}

}  // namespace

std::optional<ServerReply> move(World& world, Player& player, const soccer::Move& command,
                                Events& events) {
  if (player.command_done) return std::nullopt;
  const Vec2 position = Vec2{command.x, command.y} * sign(player.side);
  std::optional<ServerReply> reply;

  if (may_move_anywhere(world.mode)) {
    player.position = position;
    resolve_collisions(world, events);
    reply = opponent_field_warning(world, player, command.x);
  } else if (may_move_with_ball(world, player)) {
    if (has_move_left(world, player)) {
      player.position = position;
      ++player.moves_since_catch;
    } else {
      reply = soccer::reply_of(soccer::ErrorCode::kTooManyMoves);
    }
  } else {
    return std::nullopt;
  }

  occupy_legs(player);
  player.command_done = true;
  ++player.counters.move;
  return reply;
}

}  // namespace cls::simulator::actions
