// A folder of a test's own, gone when the test ends.
#pragma once

#include <filesystem>

namespace cls::tests {

/// An empty folder with a name that nobody else has, so that the same test may run in several
/// builds and for several users at once. Removed with all it holds at the end of the scope.
class TemporaryFolder {
 public:
  /// Throws std::system_error, which fails the test, when none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace cls::tests
