// Writing a keepaway log (kwy): one line an episode.
#pragma once

#include <string>

#include "base/io/byte_sink.h"

namespace cls::gamelog {

/// How the keepers lost the ball.
enum class KeepawayLoss : char { kOutOfBounds = 'o', kTaken = 't' };

/// Writes into `sink`, which must outlive the writer, as rcssserver 19 does.
class KeepawayLogWriter {
 public:
  explicit KeepawayLogWriter(base::ByteSink& sink) : sink_(sink) {}

  /// Once, before the first episode; the size of the area in metres.
  void begin(int keepers, int takers, double length, double width);

  /// `number` from 1; start and end in cycles.
  void episode(int number, int start, int end, KeepawayLoss loss);

 private:
  base::ByteSink& sink_;
  std::string text_;
};

}  // namespace cls::gamelog
