// Border lines of the pitch in the line of sight of a player.
#pragma once

#include <array>
#include <cstddef>

#include "simulator/world/player.h"
#include "soccer/pitch.h"

namespace cls::simulator {

/// Intersection of the line of sight with a border line.
struct SightLine {
  soccer::PitchLine line = soccer::PitchLine::kLeft;
  double distance = 0.0;   ///< along the line of sight
  double direction = 0.0;  ///< radians: angle between sight and line, as in see messages
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

/// In message order. At most one from inside the pitch, two from outside; independent of the view
/// cone (docs/spec/simulation-model.md 7.8).
SightLines lines_in_sight(const Player& player);

}  // namespace cls::simulator
