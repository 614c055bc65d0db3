// Formats the lines of text game logs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"
#include "gamelog/record/rcg_version.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::gamelog {

// Every function appends one line with its line feed in the form of rcssserver 19
// (docs/spec/log-formats.md 1.7): positions and velocities to 0.0001, angles to 0.001, all with six
// significant digits, negative zero as "-0".

/// `ULG4` to `ULG7`.
void append_version(RcgVersion version, std::string& out);

/// The first lines of a log: version, parameters, player types.
void append_header(RcgVersion version, const soccer::ServerParams& server,
                   const soccer::PlayerParams& player, const std::vector<soccer::PlayerType>& types,
                   std::string& out);

/// A space before each: names, scores and, after the first kick of either team, the four penalty
/// numbers.
void append_team_state(const TeamFrames& teams, std::string& out);

void append_play_mode(int time, soccer::PlayMode mode, std::string& out);

void append_team(int time, const TeamFrames& teams, std::string& out);

/// Versions 4 to 7: version 4 has no stamina capacity, only versions 6 and 7 have the focus point
/// and its counter, only version 7 has the height of the ball.
void append_show(const Frame& frame, std::string& out, RcgVersion version = RcgVersion::kV6);

/// Appends only ball and players, each after a space, without a line feed.
void append_objects(const Frame& frame, std::string& out, RcgVersion version);

/// `board` 1: referee, say messages, result, team graphics; 2: commands. Line feeds in the text
/// become spaces; nothing else is escaped, as in rcssserver.
void append_message(int time, int board, std::string_view text, std::string& out);

}  // namespace cls::gamelog
