// Who is there: teams and players joining, leaving and coming back.
#pragma once

#include <optional>
#include <string_view>

#include "simulator/world/event.h"

namespace cls::simulator {

/// The next free player of a team, standing on the bench and enabled; nothing if the team is full
/// or has a goalie already and `goalie` is asked for (1.5).
std::optional<Slot> join(World& world, Side side, bool goalie, int client_version);

/// The player stands at the bench place again, with its counters, stamina and cards. The caller
/// has checked that it may come back (4.16).
void rejoin(World& world, Slot slot);

/// The player leaves the pitch: bye, a lost connection.
void leave(World& world, Slot slot);

/// A red card: the player leaves and may not come back.
void send_off(World& world, Slot slot, Events& events);

/// Players of a team that have been connected.
int joined_count(const World& world, Side side);

/// The side of the team with that name; neutral if there is none.
Side side_called(const World& world, std::string_view team);

/// The name of the team on `side` as clients of side `watcher` are told it: opponents may have a
/// fixed one (fixed_teamname_l and _r); a neutral watcher is told the real one. Empty if there is
/// no such team yet.
soccer::TeamName shown_name(const World& world, Side watcher, Side side);

/// A player that has been connected; nothing for a number that has not.
std::optional<Slot> find_player(const World& world, Side side, int unum);

bool has_enabled_goalie(const World& world, Side side);

}  // namespace cls::simulator
