// Follows a match by the game log that its server is still writing.
#pragma once

#include <filesystem>
#include <string>

#include "base/system/unique_fd.h"
#include "match/result/match_observer.h"

namespace cls::match {

/// Reads what was appended to a game log (rcg) of version 4 to 6 since the last poll. It needs no
/// connection to the server; a connected monitor would slow down rcssserver's clock. Servers write
/// logs in blocks, so the progress is some cycles old.
class GameLogFollower {
 public:
  explicit GameLogFollower(std::filesystem::path file) : file_(std::move(file)) {}

  /// Reads what is new. Cheap when nothing is.
  void poll();
  const SourceProgress& progress() const { return progress_; }

 private:
  void read_bytes(const char* bytes, std::size_t size);
  void read_line();

  std::filesystem::path file_;
  base::UniqueFd fd_;
  std::string line_;  ///< only its beginning, which is enough to recognize it
  SourceProgress progress_;
};

}  // namespace cls::match
