// Commands of monitors: one struct per command.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "soccer/commands/player_command.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::soccer {

/// Kick-off.
struct DispStart {};
struct DispBye {};
/// A free kick for `side`, or a drop ball if neutral.
struct DispFoul {
  Vec2 position;
  Side side = Side::kNeutral;
};
/// Moves a player and sets its velocity to 0.
struct DispPlayer {
  Side side = Side::kLeft;
  int unum = 0;
  Vec2 position;
  double body = 0.0;  ///< degrees
};
/// Removes a player from the pitch.
struct DispDiscard {
  Side side = Side::kLeft;
  int unum = 0;
};
struct DispCard {
  Side side = Side::kLeft;
  int unum = 0;
  bool red = false;
};

using MonitorCommand =
    std::variant<DispStart, DispBye, DispFoul, DispPlayer, DispDiscard, DispCard, Compression>;

/// Parses the command of a datagram and ignores the rest. Positions are sent in 1/16 m, sides as 1
/// and -1 (docs/spec/server-protocol.md 6.5). Nothing for unknown commands and cards that are not
/// yellow or red. Players that do not exist get the neutral side.
std::optional<MonitorCommand> parse_monitor_command(std::string_view datagram);

/// Appends the command as monitors send it; positions are rounded to 1/16 m.
void format(const MonitorCommand& command, std::string& out);

}  // namespace cls::soccer
