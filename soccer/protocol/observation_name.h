// Names of observed objects: "(f r t 20)", "(p \"TEAM\" 7 goalie)".
#pragma once

#include <cstdint>
#include <string>

#include "soccer/protocol/scanner.h"
#include "soccer/protocol/team_name.h"
#include "soccer/protocol/text_writer.h"

namespace cls::soccer {

/// Reads the short name of a landmark, "f r t 20", up to its closing parenthesis.
bool read_landmark(Scanner& in, std::uint8_t& index);

/// Reads `"TEAM"`: one to fifteen characters between quotes.
bool read_team(Scanner& in, TeamName& team);

/// Reads `"TEAM" UNUM` or `"TEAM" UNUM goalie`.
bool read_player(Scanner& in, TeamName& team, int& unum, bool& goalie);
void append_player(const TeamName& team, int unum, bool goalie, TextWriter& out);
void append_player(const TeamName& team, int unum, bool goalie, std::string& out);

}  // namespace cls::soccer
