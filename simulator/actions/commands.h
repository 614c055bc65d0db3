// The effect of each command, called by apply().
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator::actions {

// Body commands: at most one per cycle takes effect, later ones are ignored (4.1).
void turn(World& world, Player& player, const soccer::Turn& command);
void dash(World& world, Player& player, const soccer::Dash& command);
/// Asks only whether the leg itself is free, so it works after a kick and even under a tackle.
void dash(World& world, Player& player, const soccer::LegDash& command);
void kick(World& world, Player& player, const soccer::Kick& command, Events& events);
void tackle(World& world, Player& player, const soccer::Tackle& command, Events& events);
void catch_ball(World& world, Player& player, const soccer::Catch& command, Events& events);
std::optional<soccer::ServerReply> move(World& world, Player& player, const soccer::Move& command,
                                        Events& events);

// Head and eyes.
void turn_neck(World& world, Player& player, const soccer::TurnNeck& command);
void change_focus(World& world, Player& player, const soccer::ChangeFocus& command);
void change_view(World& world, Player& player, const soccer::ChangeView& command);

// Arm, voice and ears.
void point_to(World& world, Player& player, const soccer::PointTo& command);
void stop_pointing(World& world, Player& player);
void attend(World& world, Player& player, const soccer::AttentionTo& command);
void stop_attending(Player& player);
void say(World& world, Player& player, const soccer::Say& command, Events& events);
std::optional<soccer::ServerReply> set_ears(World& world, Player& player,
                                            const soccer::Ear& command);

/// No further leg command in this cycle.
void occupy_legs(Player& player);

/// Ball seen from the player, turned so that `direction` (radians, on the pitch) is the x axis.
Vec2 ball_relative_to(const World& world, const Player& player, double direction);

/// True in the modes in which a ball that is kicked does not move: before kick-off, stopped, over.
bool ball_is_dead(PlayMode mode);

/// Noise on the ball's acceleration after a kick or tackle: a disc of that radius. None, but drawn
/// all the same and noted, while outcomes are forced.
Vec2 ball_noise(World& world, double radius, RandomStream& stream);

/// kick_rand of the player's type, with the team's factor.
double kick_rand(const World& world, const Player& player);

/// How much a moving ball makes kicks less exact: 0.5 at rest, more with speed.
double ball_speed_noise_rate(const World& world);

}  // namespace cls::simulator::actions
