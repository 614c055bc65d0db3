// Which border lines of the pitch a player looks at.
#pragma once

#include <array>
#include <cstddef>

#include "simulator/world/player.h"
#include "soccer/pitch.h"

namespace cls::simulator {

/// Where the line of sight meets a border line.
struct SightLine {
  soccer::PitchLine line = soccer::PitchLine::kLeft;
  double distance = 0.0;   ///< along the line of sight
  double direction = 0.0;  ///< radians: the angle between sight and line, as see messages have it
};

/// At most two.
class SightLines {
 public:
  void add(const SightLine& line) { lines_[count_++] = line; }
  std::size_t size() const { return count_; }
  const SightLine* begin() const { return lines_.data(); }
  const SightLine* end() const { return lines_.data() + count_; }

 private:
  std::array<SightLine, 2> lines_;
  std::size_t count_ = 0;
};

/// In message order. One at most from inside the pitch, two from outside; the view cone plays no
/// part (simulation model 7.8).
SightLines lines_in_sight(const Player& player);

}  // namespace cls::simulator
