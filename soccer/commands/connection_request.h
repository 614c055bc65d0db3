// How clients ask to take part: init, reconnect and dispinit of each role.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "soccer/protocol/reply_code.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

// All requests are read as rcssserver 19 reads them (protocol 1.2 to 1.6). A parser returns
// nothing when the text is well formed, else the error to answer with. Whether the version, the
// team or the number is acceptable is the server's decision, not the parser's.

/// `(init TEAM (version V) (goalie))`. A missing version means 3.
struct PlayerInit {
  TeamName team;
  double version = 3.0;
  bool goalie = false;
};

/// `(reconnect TEAM UNUM)`. After a form error the real server answers with
/// kNoSuchTeamOrPlayer as well.
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

/// What an unknown address may send to the port of players and monitors.
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
