// Perception: updates a world model by one typed server message each.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/server_reply.h"

namespace cls::player {

// Order within cycle T: sense_body of T starts the step, hear and see of T follow, then
// update_derived() and the decision, then record_sent_commands(). A repeated T is a step of a
// stopped clock. Reads no clock; does not allocate after the first cycles.

/// Sets side, number and mode; `team_name` and `goalie` as in the init request.
void on_init(WorldModel& world, const soccer::PlayerInitReply& reply, soccer::TeamName team_name,
             bool goalie);

/// Handles server_param, player_param and player_type. Fails on parse errors.
base::Result<void> on_parameter_message(WorldModel& world, std::string_view message);
void on_server_param(WorldModel& world, const soccer::ServerParams& params);
void on_player_param(WorldModel& world, const soccer::PlayerParams& params);
void on_player_type(WorldModel& world, const soccer::PlayerType& type);
/// The server confirmed (gaussian_see): from now on distances have Gaussian noise.
void on_gaussian_see(WorldModel& world);
void on_change_player_type(WorldModel& world, const soccer::PlayerTypeChange& change);

/// Starts a new step: increments ages, predicts all estimates one cycle ahead, applies own commands
/// confirmed by the counters.
void on_sense_body(WorldModel& world, const soccer::SenseBody& sense);

/// Localizes the agent, then updates ball and players. Ignores a late see message of an earlier
/// cycle.
void on_see(WorldModel& world, const soccer::See& see);

void on_hear(WorldModel& world, const soccer::Hear& hear);

/// Records the commands sent in the current cycle; call it once per decision.
void record_sent_commands(WorldModel& world, const std::vector<soccer::PlayerCommand>& commands);

/// Computes what a decision needs: goalie numbers, distances, kickable flags, probabilities, lines,
/// intercept table. Call it once per decision.
void update_derived(WorldModel& world);

/// Updates play mode, score, shoot-out and ball position by a referee message. Ignores unknown
/// messages.
void hear_referee(WorldModel& world, int time, std::string_view message);

/// Handles a say message: stores it for the current decision, and updates estimates by teammates
/// and coach.
void hear_message(WorldModel& world, const soccer::Hear& hear);

/// Updates ball and players by the say messages in `text` of teammate `speaker`: positions of
/// unseen objects, numbers of unnumbered players. Heard values have age 1. Stops at the first
/// invalid message.
void apply_say_messages(WorldModel& world, int speaker, std::string_view text);

}  // namespace cls::player
