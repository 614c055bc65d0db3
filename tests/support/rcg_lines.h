// Enough reading of version 6 game logs for tests: truth to compare with, lines to write again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"

namespace cls::tests {

/// The lines of a text, without line feeds.
std::vector<std::string_view> split_lines(std::string_view text);

/// A `(show ...)` line; mode and teams are left as they are. Throws std::runtime_error on anything
/// that is not one.
void read_show(std::string_view line, gamelog::Frame& frame);

/// A `(playmode ...)` line into frame.mode.
void read_play_mode(std::string_view line, gamelog::Frame& frame);

/// A `(team ...)` line into frame.teams.
void read_team(std::string_view line, gamelog::Frame& frame);

/// All shows of a log, each with the mode and the teams that hold for it.
std::vector<gamelog::Frame> read_frames(std::string_view log);

}  // namespace cls::tests
