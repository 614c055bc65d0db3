// A folder for temporary files.
#pragma once

#include <filesystem>
#include <utility>

#include "base/result.h"

namespace cls::process {

/// Deletes a folder with all in it, also with folders that a program has made read-only.
void remove_tree(const std::filesystem::path& folder);

/// A new folder that other users cannot enter, in that of TMPDIR or /tmp; deleted with its content
/// at the end of the scope, or by the guard if cls is killed.
class ScratchFolder {
 public:
  /// The error names the folder of TMPDIR, the cause and the remedy.
  static base::Result<ScratchFolder> create();
  ScratchFolder(ScratchFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;  ///< empty after a move
};

}  // namespace cls::process
