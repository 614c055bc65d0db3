// Effects of trainer and monitor commands on the world (docs/spec/simulation-model.md 10).
#pragma once

#include <optional>

#include "simulator/world/event.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/monitor_command.h"
#include "soccer/messages/server_reply.h"

namespace cls::simulator {

void move_ball(World& world, Vec2 position, Vec2 velocity);

/// Angle in degrees; values that are not given stay unchanged.
void move_player(World& world, Slot slot, Vec2 position, std::optional<double> body_degrees,
                 std::optional<Vec2> velocity, Events& events);

/// Result of check_ball (docs/spec/simulation-model.md 1.4).
soccer::BallPlace locate_ball(const World& world);

/// Executes a command of a trainer, or of a monitor acting as one, and returns the reply. Commands
/// that the session handles have no effect and no reply.
std::optional<soccer::ServerReply> apply(World& world, const soccer::CoachCommand& command,
                                         Events& events);

/// Executes a monitor command: the human referee (docs/spec/simulation-model.md 10.2). No effect
/// for commands that the session handles, players that are not on the pitch, and set plays during a
/// shoot-out.
void apply(World& world, const soccer::MonitorCommand& command, Events& events);

}  // namespace cls::simulator
