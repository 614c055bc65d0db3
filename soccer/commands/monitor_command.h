// What monitors say to the server: one struct per command.
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
/// A free kick for `side`; neutral: a drop ball.
struct DispFoul {
  Vec2 position;
  Side side = Side::kNeutral;
};
/// Puts a player somewhere, standing still.
struct DispPlayer {
  Side side = Side::kLeft;
  int unum = 0;
  Vec2 position;
  double body = 0.0;  ///< degrees
};
/// Takes a player off the pitch.
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

/// Reads the one command of a datagram; what follows it is ignored. Places are sent in sixteenths
/// of a metre, sides as 1 and -1 (protocol 6.5). Nothing when there is no such command: a card must
/// be yellow or red. Who is none of the 22 is read as of the neutral side.
std::optional<MonitorCommand> parse_monitor_command(std::string_view datagram);

/// Appends the command as monitors write it; places are rounded to sixteenths of a metre.
void format(const MonitorCommand& command, std::string& out);

}  // namespace cls::soccer
