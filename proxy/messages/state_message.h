// What a Playmaker is told before every decision: an agent's beliefs as a State.
#pragma once

#include <array>

#include "proto/playmaker.pb.h"
#include "proxy/world/world_model.h"
#include "soccer/commands/coach_command.h"
#include "soccer/play_mode.h"

namespace cls::proxy {

using HomePositions = std::array<soccer::Vec2, soccer::kPlayersPerTeam>;

/// Writes a completed world into `out`, which may be the State of the cycle before: memory is used
/// again, register_response stays as it is. Every field that needs no planner is set as
/// playmaker-wire and proxy-behaviour 3 define it, except that what was never observed is (0, 0)
/// with the age 1000, never infinite. full_world_model stays unset.
void fill_state(const WorldModel& world, const HomePositions& home, bool need_preprocess,
                protos::State& out);

/// The same for a coach or trainer, completed by proxy/coach/global_perception.h: without self,
/// intercept table and home positions. Counts are 0 and places the server's, since it sees all.
/// A trainer's side is unknown; "our" means the left team.
void fill_coach_state(const WorldModel& world, soccer::CoachRole role, protos::State& out);

/// The mode's word on the wire. drop_ball, which has none, is PlayOn.
protos::GameModeType wire_mode(soccer::PlayMode mode);

}  // namespace cls::proxy
