// A temporary folder of a test.
#pragma once

#include <filesystem>

namespace cls::tests {

/// An empty folder with a unique name, so that tests may run concurrently. Removed with its content
/// at the end of the scope.
class TemporaryFolder {
 public:
  /// Throws std::system_error, which fails the test, if it cannot be created.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cls::tests
