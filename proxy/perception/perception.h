// From server messages to beliefs: each function takes one typed message into a world model.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "proxy/world/world_model.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/server_reply.h"

namespace cls::proxy {

// Order within a cycle T: sense_body of T opens it, hear and see of T follow, then complete() and
// the decision, then note_sent_commands() with what the agent sent. A sense_body that repeats T
// opens a moment of a standing clock. Nothing here reads a clock, and after the first cycles
// nothing allocates.

/// Side, number and mode. `team_name` and `goalie` are what the agent asked for.
void on_init(WorldModel& world, const soccer::PlayerInitReply& reply, soccer::TeamName team_name,
             bool goalie);

/// Any of server_param, player_param and player_type. The error says why it is not understood.
base::Result<void> on_parameter_message(WorldModel& world, std::string_view message);
void on_server_param(WorldModel& world, const soccer::ServerParams& params);
void on_player_param(WorldModel& world, const soccer::PlayerParams& params);
void on_player_type(WorldModel& world, const soccer::PlayerType& type);
void on_change_player_type(WorldModel& world, const soccer::PlayerTypeChange& change);

/// Opens a new moment: ages grow, everything is advanced by one cycle, own commands are taken into
/// account as far as the counters say that they were carried out.
void on_sense_body(WorldModel& world, const soccer::SenseBody& sense);

/// Localises the agent, then ball and players. A see of another cycle than the present one is
/// ignored (it came late and describes the past).
void on_see(WorldModel& world, const soccer::See& see);

void on_hear(WorldModel& world, const soccer::Hear& hear);

/// What the agent sends for the running cycle; call it once per decision.
void note_sent_commands(WorldModel& world, const std::vector<soccer::PlayerCommand>& commands);

/// Derives what a decision needs: identities of the goalies, distances, kickable flags,
/// probabilities, lines, intercept table. Call it once per decision.
void complete(WorldModel& world);

}  // namespace cls::proxy
