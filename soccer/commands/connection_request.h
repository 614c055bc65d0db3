// Connection requests of clients: init, reconnect and dispinit.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "soccer/protocol/reply_code.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

// Requests are parsed like in rcssserver 19 (docs/spec/server-protocol.md 1.2 to 1.6). Parsers
// return nothing for well-formed text, otherwise the error reply. The server, not the parser,
// decides whether version, team and uniform number are acceptable.

/// `(init TEAM (version V) (goalie))`. A missing version means 3.
struct PlayerInit {
  TeamName team;
  double version = 3.0;
  bool goalie = false;
};

/// `(reconnect TEAM UNUM)`. rcssserver replies kNoSuchTeamOrPlayer to malformed requests too.
struct PlayerReconnect {
  std::string team;
  int unum = 0;
};

/// `(dispinit)` is version 1; `(dispinit version N)`: N = 1..5, -1 for JSON.
struct MonitorInit {
  double version = 1.0;
};

/// `(init TEAM COACHNAME (version V))`; name and version optional, a missing version means 5.
struct CoachInit {
  TeamName team;
  std::string coach_name;
  double version = 5.0;
};

/// `(init (version V))`, a missing version means 3.
struct TrainerInit {
  double version = 3.0;
};

/// Requests of a new client on the port of players and monitors.
using GameRequest = std::variant<PlayerInit, PlayerReconnect, MonitorInit>;

std::optional<ErrorCode> parse(std::string_view datagram, GameRequest& out);
std::optional<ErrorCode> parse(std::string_view datagram, CoachInit& out);
std::optional<ErrorCode> parse(std::string_view datagram, TrainerInit& out);

void format(const PlayerInit& request, std::string& out);
void format(const PlayerReconnect& request, std::string& out);
void format(const MonitorInit& request, std::string& out);
void format(const CoachInit& request, std::string& out);
void format(const TrainerInit& request, std::string& out);

}  // namespace cls::soccer
