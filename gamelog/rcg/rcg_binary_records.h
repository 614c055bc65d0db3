// The records of binary game logs (rcg, versions 1 to 3), one function each.
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

// Every function appends what the version has for it (log-formats 1.4 to 1.6), perhaps nothing.
// Where the real server leaves what was in memory, there are NULs.

/// Version and, in version 3, parameters.
void append_binary_header(RcgVersion version, const soccer::ServerParams& server,
                          const soccer::PlayerParams& player,
                          const std::vector<soccer::PlayerType>& types, std::string& out);

// Versions 1 and 2 have these two in every show.
void append_binary_play_mode(RcgVersion version, soccer::PlayMode mode, std::string& out);
void append_binary_teams(RcgVersion version, const TeamFrames& teams, std::string& out);

void append_binary_show(RcgVersion version, const Frame& frame, std::string& out);

/// At most 2048 bytes of the text, 2047 in version 1.
void append_binary_message(RcgVersion version, int board, std::string_view text, std::string& out);

}  // namespace cls::gamelog
