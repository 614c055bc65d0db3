// Formats binary game log records (rcg versions 1 to 3) and monitor datagrams (versions 1 and 2).
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

// Each of these appends the records of one version of the log (docs/spec/log-formats.md 1.4 to
// 1.6), nothing if the version has none. Bytes that rcssserver leaves uninitialized are NUL.

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

// Each of these appends one datagram of the fixed size of its monitor version
// (docs/spec/server-protocol.md 6.4), padded with NULs.

/// Version 1: positions in sixteenths of a meter, whole degrees.
void append_short_show(const Frame& frame, std::string& out);

/// Version 2: reals times 65536.
void append_long_show(const Frame& frame, std::string& out);

/// `version` is 1 or 2.
void append_binary_text(int version, int board, std::string_view text, std::string& out);

// Version 2.
/// ServerParams, PlayerParams or a PlayerType.
template <typename Params>
void append_binary_parameters(const Params& params, std::string& out);

}  // namespace cls::gamelog
