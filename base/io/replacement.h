// Files that get their name once they are complete.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "base/system/unique_fd.h"

namespace cls::base {

/// Replaces a regular file, or creates one, so that readers see the old bytes or all new ones: what
/// is written to place() gets the name of the file by finish(). A device, pipe, socket or link is
/// written into instead: then place() is the file itself. What a killed process leaves,
/// remove_abandoned() finds.
class Replacement {
 public:
  /// Creates place(): beside `file`, with its extension, exclusively and under an unpredictable
  /// name. The error names `file` and the cause.
  static Result<Replacement> start(std::filesystem::path file);

  Replacement(Replacement&& other) noexcept;
  Replacement& operator=(Replacement&&) = delete;
  /// Removes an unfinished place().
  ~Replacement();

  const std::filesystem::path& place() const { return place_; }
  /// Descriptor of place(), open for writing and empty; -1 when place() is the file itself.
  int descriptor() const { return file_descriptor_.get(); }
  /// Renames place(). What the caller has opened there must be closed.
  Result<void> finish();

 private:
  Replacement(std::filesystem::path file, std::filesystem::path place, UniqueFd descriptor);

  std::filesystem::path file_;
  std::filesystem::path place_;
  UniqueFd file_descriptor_;  ///< locks place() as long as this process lives
  bool pending_ = false;      ///< place() is a temporary file
};

/// Removes the temporary files in `folder` whose processes have ended.
void remove_abandoned(const std::filesystem::path& folder);

}  // namespace cls::base
