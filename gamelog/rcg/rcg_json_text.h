// Formats the elements of JSON game logs.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/record/frame.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

// Every function appends one object in the form of rcssserver 19 (docs/spec/log-formats.md 1.10),
// without a comma or line feed around it. `stopped` is left out if it is 0. Numbers have the form
// of text logs. In strings, quotes, backslashes and control characters are escaped (rcssserver does
// not escape the last); other bytes are copied.

/// `{"version":"19.0.0"}`, `{"timestamp":...}`.
void append_json_text(std::string_view key, std::string_view value, std::string& out);

/// Converts a parameter line of a text log; the parameter tables tell which values are booleans.
void append_json_parameters(std::string_view line, std::string& out);

void append_json_play_mode(int time, int stopped, soccer::PlayMode mode, std::string& out);

/// Penalty numbers of a team appear after its first kick.
void append_json_team(int time, int stopped, const TeamFrames& teams, std::string& out);

/// Shows of logs have counters; those of monitors have focus point, mode and teams instead.
enum class JsonShow { kLog, kMonitor };
void append_json_show(const Frame& frame, std::string& out, JsonShow form = JsonShow::kLog);

/// A team graphic becomes a separate object.
void append_json_message(int time, int stopped, const Message& message, std::string& out);

}  // namespace cls::gamelog
