// `cls watch --view terminal`: a match in characters, for hosts without a browser.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "gamelog/record/match_record.h"
#include "viewer/live/live_input.h"

namespace cls::cli {

struct TerminalViewOptions {
  std::string title;
  std::optional<int> at;  ///< cycle to show first
  std::string cast;       ///< asciinema recording to write; empty: none
};

// Both return an exit code and print errors. They restore the terminal when they end, also after
// Ctrl-C. Without a terminal on stdout a running match is one line per second.

/// Plays a recorded match. With a cast it renders all of it into the file and shows nothing.
int show_in_terminal(const gamelog::MatchRecord& record, const TerminalViewOptions& options);

/// Follows a running match.
int show_in_terminal(std::unique_ptr<viewer::LiveInput> input, const TerminalViewOptions& options);

}  // namespace cls::cli
