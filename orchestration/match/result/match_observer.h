// Who wants to see a match while it runs: the progress line, tests, later the live view.
#pragma once

#include <string_view>

#include "soccer/play_mode.h"

namespace cls::orchestration::match {

/// What is worth showing after a cycle.
struct MatchProgress {
  int cycle = 0;
  int last_cycle = 0;  ///< where the match will end as far as known
  int left_score = 0;
  int right_score = 0;
  soccer::PlayMode mode = soccer::PlayMode::kNull;
};

/// Called from the thread that runs the match. Must return quickly.
class MatchObserver {
 public:
  virtual ~MatchObserver() = default;
  virtual void on_phase(std::string_view /*what*/) {}  ///< "connecting to left ...", one line
  virtual void on_cycle(const MatchProgress& /*progress*/) {}
  virtual void on_notice(std::string_view /*line*/) {}  ///< worth keeping on the screen
  virtual void on_warning(std::string_view /*line*/) {}
};

}  // namespace cls::orchestration::match
