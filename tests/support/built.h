// Programs of this build.
#pragma once

#include <filesystem>
#include <string>

namespace cls::tests {

/// Path of a fake or tool of this build. Only for test binaries, which define CLS_BUILD_DIR.
inline std::string built(const std::string& name) {
  return std::string(CLS_BUILD_DIR) + "/bin/" + name;
}

/// Copies a program of this build into `folder` and returns the copy's path: external teams cannot
/// use the build folder from their sandbox.
inline std::string copy_built(const std::string& name, const std::filesystem::path& folder) {
  const std::filesystem::path copy = folder / name;
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(built(name), copy, std::filesystem::copy_options::overwrite_existing);
  return copy.string();
}

}  // namespace cls::tests
