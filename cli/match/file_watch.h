// Which files of a project have changed.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cls::cli {

/// Files by path from the folder, with what tells one version from another.
using FileVersions =
    std::map<std::string, std::pair<std::filesystem::file_time_type, std::uintmax_t>>;

/// The files below `folder`, without hidden ones, those that its .gitignore names, and what
/// builds and matches write: node_modules, __pycache__, target, runs, match.
FileVersions file_versions(const std::filesystem::path& folder);

/// Paths that are new, gone or other than before.
std::vector<std::string> changed_files(const FileVersions& before, const FileVersions& now);

}  // namespace cls::cli
