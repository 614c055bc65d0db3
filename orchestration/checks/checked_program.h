// Programs started by a check: their folder for logs, and how they exited.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "orchestration/process/process_host.h"

namespace cls::orchestration::checks {

/// Deleted with its content at the end of the scope. The path is empty if it cannot be created.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "cls-check-XXXXXX").string();
    if (::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// "WHAT exited (exit code 3); last output line: cannot load the formation"; empty while it runs.
std::string describe_exit(const std::string& what, const process::Child& child);

}  // namespace cls::orchestration::checks
