// Implementations of the player commands, called by apply().
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator::actions {

// Body commands: only the first in a cycle takes effect (docs/spec/simulation-model.md 4.1).
void turn(World& world, Player& player, const soccer::Turn& command);
void dash(World& world, Player& player, const soccer::Dash& command);
/// Checks only whether the leg itself is free, so it works after a kick and during a tackle.
void dash(World& world, Player& player, const soccer::LegDash& command);
void kick(World& world, Player& player, const soccer::Kick& command, Events& events);
void tackle(World& world, Player& player, const soccer::Tackle& command, Events& events);
void catch_ball(World& world, Player& player, const soccer::Catch& command, Events& events);
std::optional<soccer::ServerReply> move(World& world, Player& player, const soccer::Move& command,
                                        Events& events);

// Neck and view.
void turn_neck(World& world, Player& player, const soccer::TurnNeck& command);
void change_focus(World& world, Player& player, const soccer::ChangeFocus& command);
void change_view(World& world, Player& player, const soccer::ChangeView& command);

// Arm, say and hearing.
void point_to(World& world, Player& player, const soccer::PointTo& command);
void stop_pointing(World& world, Player& player);
void attend(World& world, Player& player, const soccer::AttentionTo& command);
void stop_attending(Player& player);
void say(World& world, Player& player, const soccer::Say& command, Events& events);
std::optional<soccer::ServerReply> set_ears(World& world, Player& player,
                                            const soccer::Ear& command);

/// Blocks leg commands for the rest of the cycle.
void occupy_legs(Player& player);

/// Ball position relative to the player; the x axis is `direction` (radians, pitch coordinates).
Vec2 ball_relative_to(const World& world, const Player& player, double direction);

/// True in modes in which a kick does not move the ball: before kick-off, stopped, over.
bool ball_is_dead(PlayMode mode);

/// Noise of the ball's acceleration after a kick or tackle, from a disc of that radius. During log
/// replay it is drawn and recorded in the overrides, but zero.
Vec2 ball_noise(World& world, double radius, RandomStream& stream);

/// kick_rand of the player type times the factor of the team.
double kick_rand(const World& world, const Player& player);

/// Factor of kick noise by the speed of the ball: 0.5 at rest.
double ball_speed_noise_rate(const World& world);

}  // namespace cls::simulator::actions
