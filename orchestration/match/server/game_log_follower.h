// Follows a match by the game log that its server is still writing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "orchestration/process/unique_fd.h"
#include "soccer/play_mode.h"

namespace cls::orchestration::match {

/// Where a match is, as far as its log has come to the disk: servers write in blocks, so this is
/// some cycles behind.
struct LoggedMoment {
  std::int64_t shows = 0;  ///< frames so far: grows also while the clock stands
  int time = 0;
  soccer::PlayMode mode = soccer::PlayMode::kNull;
  int left_score = 0;
  int right_score = 0;
};

/// Reads what has been added to a game log of version 4 to 6 since the last look. It needs no
/// connection to the server, whose clock a connected monitor would slow down.
class GameLogFollower {
 public:
  explicit GameLogFollower(std::filesystem::path file) : file_(std::move(file)) {}

  /// Takes in what is new. Call it as often as you like.
  void look();
  /// What the last look showed.
  const LoggedMoment& moment() const { return moment_; }

 private:
  void take(const char* bytes, std::size_t size);
  void take_line();

  std::filesystem::path file_;
  process::UniqueFd fd_;
  std::string line_;  // its beginning only: the first words are all that is looked at
  LoggedMoment moment_;
};

}  // namespace cls::orchestration::match
