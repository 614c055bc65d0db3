// Self, players and ball of a State.
#pragma once

#include "proto/playmaker.pb.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

// All replace whatever `out` held before and use its memory again.

protos::Side wire_side(soccer::Side side);
/// With length and direction, reckoned from the rounded coordinates. `known` is another message
/// that may hold the same vector.
void fill(soccer::Vec2 vector, protos::RpcVector2D& out,
          const protos::RpcVector2D* known = nullptr);
void fill_self(const WorldModel& world, protos::Self& out);
void fill_ball(const BallState& ball, protos::Ball& out);
/// `decay` is that of the player's type; `twin` another message about the same player, filled
/// already, or null.
void fill_player(const PlayerState& player, double decay, const protos::Player* twin,
                 protos::Player& out);
/// The agent as one of its team.
void fill_self_as_player(const WorldModel& world, protos::Player& out);

}  // namespace cls::proxy
