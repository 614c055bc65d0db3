// Clock, score and positions of a game log that grows, without reading it as a match.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.h"

namespace cls::viewer {

struct GlancePlayer {
  int unum = 0;
  soccer::Vec2 position;
};

struct Glance {
  int cycle = 0;
  int left = 0;  ///< goals
  int right = 0;
  soccer::Vec2 ball;
  std::vector<GlancePlayer> left_players = {};  ///< on the pitch
  std::vector<GlancePlayer> right_players = {};
};

/// Follows a text log (rcg 4 to 6). Each call reads what was added; a compressed log, which arrives
/// in blocks, from its start.
class LogGlance {
 public:
  explicit LogGlance(std::filesystem::path file) : file_(std::move(file)) {}

  /// The last whole frame; nothing before the first one, and for other logs.
  std::optional<Glance> now();

 private:
  void read_line(std::string_view line);
  /// Takes whole lines from the start of `text`.
  void read_lines(std::string& text);
  void read_compressed();

  std::filesystem::path file_;
  std::uintmax_t read_ = 0;  ///< bytes that were used
  /// Score and the last frame, as one value.
  std::optional<Glance> last() const;

  Glance glance_;
  std::string frame_;  ///< the line of the last one
  bool any_ = false;
};

}  // namespace cls::viewer
