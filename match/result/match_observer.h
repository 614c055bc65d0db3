// Interface for the progress of a running match: progress line, tests, live view.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "soccer/play_mode.h"

namespace cls::match {

/// Game time and score after a cycle.
struct MatchProgress {
  int cycle = 0;
  int last_cycle = 0;  ///< at which the match will end, as far as known; 0: unknown
  int left_score = 0;
  int right_score = 0;
  soccer::PlayMode mode = soccer::PlayMode::kNull;
};

/// The progress that one source (server, game log, agents) reports.
struct SourceProgress {
  MatchProgress match;
  std::int64_t steps = 0;  ///< also counts steps while the clock is stopped
};

/// Called on the thread that runs the match. Must return quickly.
class MatchObserver {
 public:
  virtual ~MatchObserver() = default;
  /// Before the match starts: its folder, and the game log that will be in it (empty: none).
  virtual void on_folder(const std::filesystem::path& /*folder*/, const std::string& /*game_log*/) {
  }
  virtual void on_phase(std::string_view /*what*/) {}  ///< "connecting to left ...", one line
  virtual void on_cycle(const MatchProgress& /*progress*/) {}
  virtual void on_notice(std::string_view /*line*/) {}  ///< stays on the screen
  virtual void on_warning(std::string_view /*line*/) {}
};

}  // namespace cls::match
