// Writing the log of a match of keepaway.
#pragma once

#include "base/io/byte_sink.h"
#include "gamelog/rcl/keepaway_log.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// Finds episodes and their ends in the world. Nothing is written where nobody plays keepaway.
class KeepawayRecorder {
 public:
  /// The sink must outlive the recorder.
  explicit KeepawayRecorder(base::ByteSink& sink) : log_(sink) {}

  /// Every step, after it.
  void step(const World& world);

 private:
  gamelog::KeepawayLogWriter log_;
  int episode_ = 0;  ///< the one under way
  int start_ = 0;    ///< 0 for the first one, whenever it began, as in the real server
};

}  // namespace cls::simulator
