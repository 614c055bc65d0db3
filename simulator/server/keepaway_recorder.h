// Writing the log of a match of keepaway.
#pragma once

#include "gamelog/byte_sink.h"
#include "gamelog/keepaway_log.h"
#include "simulator/world.h"

namespace cls::simulator {

/// Finds episodes and their ends in the world. Nothing is written where nobody plays keepaway.
class KeepawayRecorder {
 public:
  /// The sink must outlive the recorder.
  explicit KeepawayRecorder(gamelog::ByteSink& sink) : log_(sink) {}

  /// Every step, after it.
  void step(const World& world);

 private:
  gamelog::KeepawayLogWriter log_;
  int episode_ = 0;  ///< the one under way
  int start_ = 0;    ///< 0 for the first one, whenever it began, as in the real server
};

}  // namespace cls::simulator
