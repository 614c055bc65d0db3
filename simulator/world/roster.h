// Players and teams that join, leave and reconnect.
#pragma once

#include <optional>
#include <string_view>

#include "simulator/world/event.h"

namespace cls::simulator {

/// Clients of this version and later are in synchronous view mode from the start
/// (docs/spec/simulation-model.md 7.1).
constexpr int kFirstSynchronousVersion = 18;

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

/// Names a team by its first client. A team with the name of its opponent gets one of its own, with
/// "_l" or "_r" at the end; its clients continue to see the name that they chose.
void name_team(World& world, Side side, std::string_view name);

/// True if clients of side `viewer` call the team on `side` so. False before it has a name.
bool has_name(const World& world, Side viewer, Side side, std::string_view name);

/// Side of the team that clients of side `viewer` call so, or neutral.
Side find_side(const World& world, std::string_view team, Side viewer = Side::kNeutral);

/// Name of the team on `side` as sent to clients of side `viewer`. Opponents see the fixed name
/// (fixed_teamname_l and _r) if there is one; a neutral viewer sees the name in the match. Empty if
/// the team has not connected.
soccer::TeamName visible_team_name(const World& world, Side viewer, Side side);

/// The name of the team on `side` for a client of side `own` that calls its own team `own_name`;
/// empty: as visible_team_name(). Its opponents never have that name.
soccer::TeamName visible_team_name(const World& world, Side own, Side side,
                                   const soccer::TeamName& own_name);

/// Slot of a player that has connected; none for other uniform numbers.
std::optional<Slot> find_player(const World& world, Side side, int unum);

bool has_enabled_goalie(const World& world, Side side);

}  // namespace cls::simulator
