// The elements of a game log in JSON, one function each.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/record/frame.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

// Every function appends one object as rcssserver 19 writes it (log-formats 1.10), without the
// comma or the line feed around it. `stopped` is left out where it is 0. Numbers are those of text
// logs. In strings, quotes, backslashes and control characters are escaped (the real server leaves
// the last raw); other bytes stay as they are.

/// `{"version":"19.0.0"}`, `{"timestamp":...}`.
void append_json_text(std::string_view key, std::string_view value, std::string& out);

/// From a parameter line of a text log; which values are true or false, the parameter tables say.
void append_json_parameters(std::string_view line, std::string& out);

void append_json_play_mode(int time, int stopped, soccer::PlayMode mode, std::string& out);

/// The penalty numbers of a team appear once it has taken a kick.
void append_json_team(int time, int stopped, const TeamFrames& teams, std::string& out);

/// Shows of logs have no focus point; those of monitors have it, mode and teams, but no counters.
enum class JsonShow { kLog, kMonitor };
void append_json_show(const Frame& frame, std::string& out, JsonShow form = JsonShow::kLog);

/// A team graphic becomes an object of its own.
void append_json_message(int time, int stopped, const Message& message, std::string& out);

}  // namespace cls::gamelog
