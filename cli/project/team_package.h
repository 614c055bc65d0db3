// A team as a folder for machines of a competition: scripts, the program cls, the Playmaker.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::cli {

/// What a package holds.
struct TeamPackage {
  std::string name;
  std::string command;            ///< of a `run:` side, with {port}
  std::filesystem::path project;  ///< folder where the command runs
  std::filesystem::path program;  ///< the binary cls
};

/// The text of the script `start`.
std::string start_script(const TeamPackage& package);

/// Writes start, kill, cls and team/, a copy of the project without .git, runs/ and `folder`
/// itself. The error names the file.
base::Result<void> write_package(const TeamPackage& package, const std::filesystem::path& folder);

}  // namespace cls::cli
