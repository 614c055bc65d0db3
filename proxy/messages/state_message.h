// Writes an agent's world model into the State of a decision request.
#pragma once

#include <array>

#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"
#include "soccer/commands/coach_command.h"
#include "soccer/play_mode.h"

namespace cls::proxy {

using HomePositions = std::array<soccer::Vec2, soccer::kPlayersPerTeam>;

// All functions replace the content of `out` and reuse its memory.

/// Writes a completed world into `out`, possibly the State of the previous cycle, and leaves
/// register_response unchanged. Every field that needs no planner is set as
/// docs/spec/playmaker-wire.md 3.2 and docs/spec/proxy-behavior.md 3 define it, except that objects
/// never observed are at (0, 0) with age 1000, never infinite. full_world_model is left unchanged.
void fill_state(const player::WorldModel& world, const HomePositions& home, bool need_preprocess,
                protos::State& out);

/// Fills the State of a coach or trainer, completed by proxy/coach/global_perception.h: without
/// self, intercept table and home positions. Counts are 0 and positions exact. A trainer's side is
/// unknown; "our" means the left team.
void fill_coach_state(const player::WorldModel& world, soccer::CoachRole role, protos::State& out);

/// drop_ball, which GameModeType lacks, becomes PlayOn.
protos::GameModeType wire_mode(soccer::PlayMode mode);

protos::Side wire_side(soccer::Side side);
inline soccer::Vec2 vec(const protos::RpcVector2D& v) { return {v.x(), v.y()}; }
/// Fills coordinates, and length and direction computed from the rounded coordinates.
void fill(soccer::Vec2 vector, protos::RpcVector2D& out);
void fill_self(const player::WorldModel& world, protos::Self& out);
void fill_ball(const player::BallState& ball, protos::Ball& out);
/// `decay` is player_decay of the player's type.
void fill_player(const player::PlayerState& player, double decay, protos::Player& out);
/// The agent as an entry of its team.
void fill_self_as_player(const player::WorldModel& world, protos::Player& out);

}  // namespace cls::proxy
