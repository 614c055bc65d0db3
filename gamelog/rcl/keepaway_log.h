// Writes a keepaway log (kwy): one line per episode.
#pragma once

#include <string>

#include "base/io/byte_sink.h"

namespace cls::gamelog {

/// How the keepers lost the ball.
enum class KeepawayLoss : char { kOutOfBounds = 'o', kTaken = 't' };

/// Writes the format of rcssserver 19 into `sink`, which must outlive the writer.
class KeepawayLogWriter {
 public:
  explicit KeepawayLogWriter(base::ByteSink& sink) : sink_(sink) {}

  /// Writes the header, once before the first episode. Size of the area in meters.
  void write_header(int keepers, int takers, double length, double width);

  /// `number` from 1; start and end in cycles.
  void write_episode(int number, int start, int end, KeepawayLoss loss);

 private:
  base::ByteSink& sink_;
  std::string text_;
};

}  // namespace cls::gamelog
