// A team as a folder for machines of a competition: scripts, the program cls, the Playmaker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "cli/project/interpreters.h"

namespace cls::cli {

/// The contents of a package.
struct TeamPackage {
  std::string name;
  std::string command;                  ///< of a `run:` side, with {port}
  std::filesystem::path project;        ///< folder where the command runs
  std::filesystem::path program;        ///< the binary cls
  std::filesystem::path environment{};  ///< a virtual environment of Python; empty: none
  std::vector<std::string> with{};      ///< more programs for env/bin, by path or name on PATH
  /// Paths in the project that are packed although they look private or .gitignore names them.
  std::vector<std::string> include{};
};

/// The result of write_package().
struct WrittenPackage {
  std::uintmax_t program_bytes = 0;      ///< of cls and lib/
  std::uintmax_t project_bytes = 0;      ///< of team/
  std::uintmax_t environment_bytes = 0;  ///< of env/
  std::uintmax_t packed_bytes = 0;       ///< of all, as .tar.gz has them
  std::vector<BroughtInterpreter> interpreters;
  std::vector<std::string> left_out;       ///< of the project: "runs/", "first/ (match)", ...
  std::vector<std::string> links_outside;  ///< of the project: "data -> /home/ada/data"
  std::vector<std::string> missing;  ///< libraries that this host lacks: "env/x.so: libfoo.so.1"

  std::uintmax_t bytes() const { return program_bytes + project_bytes + environment_bytes; }
};

/// The text of the script `start`.
std::string start_script(const TeamPackage& package);

/// Called with each step that takes seconds: "./run build".
using PackageStep = std::function<void(std::string_view)>;

/// Writes start, kill, cls with loader and libraries, env/ with interpreters and their packages,
/// and team/, a copy of the project (copy_project). The error names the file. Until it is whole,
/// the package is FOLDER.unfinished.
base::Result<WrittenPackage> write_package(const TeamPackage& package,
                                           const std::filesystem::path& folder,
                                           const PackageStep& on_step);

/// The virtual environment that the Playmaker of a project uses: the active one ($VIRTUAL_ENV),
/// else .venv of the project; empty: none.
std::filesystem::path environment_of(const std::filesystem::path& project);

}  // namespace cls::cli
