// Looking with the neck alone, seen from where the body command of this cycle will leave us.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

// Proxy behaviour 4.4. Call them after the body command is chosen. Each sets the neck slot and
// returns true, except where said; the last call wins. "Stale" means older than a threshold in
// cycles.

/// Where nothing was seen for longest.
bool neck_scan_field(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);
/// Where the most and longest unseen players are; scans the field unless all 22 are known.
bool neck_scan_players(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);

/// Keeps the ball in view and looks around as far as that allows. Scans if it cannot.
bool neck_turn_to_ball(const WorldModel& world, const SightMemory& sight, CommandSlots& slots);
/// The ball if it is stale (a threshold of -1 always), else around.
bool neck_turn_to_ball_or_scan(const WorldModel& world, const SightMemory& sight,
                               CommandSlots& slots, int count_threshold);
/// Ball and player if the player is stale and both fit into the view, else the ball. False for a
/// player that is not known.
bool neck_turn_to_ball_and_player(const WorldModel& world, const SightMemory& sight,
                                  CommandSlots& slots, const PlayerState* player,
                                  int count_threshold);
/// The player if it is stale, else around. False for a player that is not known.
bool neck_turn_to_player_or_scan(const WorldModel& world, const SightMemory& sight,
                                 CommandSlots& slots, const PlayerState* player,
                                 int count_threshold);
/// Their goalie if it is stale, else ball or scan.
bool neck_turn_to_goalie_or_scan(const WorldModel& world, const SightMemory& sight,
                                 CommandSlots& slots, int count_threshold);
/// The teammate ahead of us that was unseen for longest, else ball or scan.
bool neck_turn_to_low_conf_teammate(const WorldModel& world, const SightMemory& sight,
                                    CommandSlots& slots);
/// The point if the neck brings it into view, else around.
bool neck_turn_to_point(const WorldModel& world, const SightMemory& sight, CommandSlots& slots,
                        soccer::Vec2 point);
/// To `angle` degrees relative to the body.
bool neck_turn_to_relative(const WorldModel& world, CommandSlots& slots, double angle);
/// What is worth knowing on the way to the ball: opponent, goal, goalie, teammates or ball.
bool neck_offensive_intercept(const WorldModel& world, const SightMemory& sight,
                              CommandSlots& slots);

}  // namespace cls::proxy
