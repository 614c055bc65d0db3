// The part of a project that a package has.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/project/team_package.h"

namespace cls::cli {

struct CopiedProject {
  std::vector<std::string> left_out;       ///< sorted: "runs/ (matches)", ".env (private)"
  std::vector<std::string> links_outside;  ///< that lead out of the project: "data -> /srv/data"
};

/// Copies the project of `package` to `to`. Leaves out, and lists: private files (private_files.h),
/// what .gitignore names except built programs, packages, folders of matches and tournaments, logs,
/// pages of cls, pipes, sockets, devices and unreadable files. Leaves out version control, caches
/// of compilers, the environment and the folder of `to`. Throws fs::filesystem_error.
CopiedProject copy_project(const TeamPackage& package, const std::filesystem::path& to);

}  // namespace cls::cli
