// A folder for temporary files.
#pragma once

#include <filesystem>

namespace cls::process {

/// A new folder that other users cannot enter, in that of TMPDIR or /tmp; deleted with its content
/// at the end of the scope, or by the guard if cls is killed. The path is empty if it cannot be
/// created.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cls::process
