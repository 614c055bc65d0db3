// Players and teams that join, leave and reconnect.
#pragma once

#include <optional>
#include <string_view>

#include "simulator/world/event.h"

namespace cls::simulator {

/// Enables the next free player of a team at its bench position. Returns no slot if the team is
/// full, or if `goalie` is set and the team already has a goalie
/// (docs/spec/simulation-model.md 1.5).
std::optional<Slot> join(World& world, Side side, bool goalie, int client_version);

/// Enables the player again at its bench position, with its former counters, stamina and cards. The
/// caller has checked that it may reconnect (docs/spec/simulation-model.md 4.16).
void rejoin(World& world, Slot slot);

/// Removes the player from the pitch after bye or a lost connection.
void leave(World& world, Slot slot);

/// Removes the player after a red card; it may not reconnect.
void send_off(World& world, Slot slot, Events& events);

/// Number of players of a team that have ever connected.
int joined_count(const World& world, Side side);

/// Side of the team with that name, or neutral.
Side find_side(const World& world, std::string_view team);

/// Name of the team on `side` as sent to clients of side `viewer`. Opponents see the fixed name
/// (fixed_teamname_l and _r) if there is one; a neutral viewer sees the real name. Empty if the
/// team has not connected.
soccer::TeamName visible_team_name(const World& world, Side viewer, Side side);

/// Slot of a player that has connected; none for other uniform numbers.
std::optional<Slot> find_player(const World& world, Side side, int unum);

bool has_enabled_goalie(const World& world, Side side);

}  // namespace cls::simulator
