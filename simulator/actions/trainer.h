// What trainers and monitors may do to the world directly (section 10).
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/coach_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

void move_ball(World& world, Vec2 position, Vec2 velocity);

/// Angle in degrees; what is not given stays.
void move_player(World& world, Slot slot, Vec2 position, std::optional<double> body_degrees,
                 std::optional<Vec2> velocity, Events& events);

/// Where the ball is, as check_ball says it (1.4).
soccer::BallPlace ball_place(const World& world);

/// Executes what a trainer or monitor may command the world, and returns the answer; nothing,
/// without an effect, for commands that are the session's business.
std::optional<soccer::ServerReply> obey(World& world, const soccer::CoachCommand& command,
                                        Events& events);

}  // namespace cls::simulator
