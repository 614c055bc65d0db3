// Minimal parser of rcg version 6 for tests: ground truth and round trips.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/frame.h"

namespace cls::tests {

/// The lines of a text, without newlines.
std::vector<std::string_view> split_lines(std::string_view text);

/// Parses a `(show ...)` line; play mode and teams stay unchanged. Throws std::runtime_error on any
/// other text.
void read_show(std::string_view line, gamelog::Frame& frame);

/// Parses a `(playmode ...)` line into frame.mode.
void read_play_mode(std::string_view line, gamelog::Frame& frame);

/// Parses a `(team ...)` line into frame.teams.
void read_team(std::string_view line, gamelog::Frame& frame);

/// All `show` frames of a log, each with its play mode and teams.
std::vector<gamelog::Frame> read_frames(std::string_view log);

}  // namespace cls::tests
