// A team as a folder for machines of a competition: scripts, the program cls, the Playmaker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// What a package holds.
struct TeamPackage {
  std::string name;
  std::string command;                  ///< of a `run:` side, with {port}
  std::filesystem::path project;        ///< folder where the command runs
  std::filesystem::path program;        ///< the binary cls
  std::filesystem::path environment{};  ///< a virtual environment of Python; empty: none
};

/// What write_package() has written.
struct WrittenPackage {
  std::uintmax_t program_bytes = 0;
  std::uintmax_t project_bytes = 0;
  std::uintmax_t environment_bytes = 0;
  std::vector<std::string> left_out;  ///< of the project: "runs/", "first/ (match)", ...

  std::uintmax_t bytes() const { return program_bytes + project_bytes + environment_bytes; }
};

/// The text of the script `start`.
std::string start_script(const TeamPackage& package);

/// Writes start, kill, cls, env/ and team/, a copy of the project without version control,
/// packages, folders of matches and tournaments, logs, pages of cls, the environment and `folder`
/// itself. The error names the file.
base::Result<WrittenPackage> write_package(const TeamPackage& package,
                                           const std::filesystem::path& folder);

/// The virtual environment that the Playmaker of a project uses: the active one ($VIRTUAL_ENV),
/// else .venv of the project; empty: none.
std::filesystem::path environment_of(const std::filesystem::path& project);

/// Why other machines, and the sandbox of `team:`, have no interpreter for an environment: it is in
/// no folder of the system. Empty: they have one.
std::string foreign_interpreter(const std::filesystem::path& environment);

}  // namespace cls::cli
