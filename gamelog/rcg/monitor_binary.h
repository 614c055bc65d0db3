// Messages to monitors of versions 1 and 2: numbers at fixed places, most significant byte first.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/rcg/monitor_message.h"
#include "gamelog/record/frame.h"

namespace cls::gamelog {

// Each appends one datagram of the size that the version demands (protocol 6.4), padded with NULs.

/// Version 1: places in sixteenths of a metre, whole degrees.
void append_short_show(const Frame& frame, std::string& out);

/// Version 2: reals times 65536.
void append_long_show(const Frame& frame, std::string& out);

/// Either version.
void append_binary_text(MonitorVersion version, int board, std::string_view text, std::string& out);

// Version 2.
void append_binary_parameters(const soccer::ServerParams& params, std::string& out);
void append_binary_parameters(const soccer::PlayerParams& params, std::string& out);
void append_binary_parameters(const soccer::PlayerType& type, std::string& out);

}  // namespace cls::gamelog
