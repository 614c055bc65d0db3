// The files of the project, without what builds and package managers put beside them.
#pragma once

#include <filesystem>
#include <vector>

namespace cls::tests {

/// The regular files in `root` that git tracks, sorted, except hidden ones and those in hidden
/// folders. Where git does not track them, as in an unpacked archive: all, except in build folders,
/// too, and those of packages.
std::vector<std::filesystem::path> files_of_project(const std::filesystem::path& root);

/// The symbolic links in `root` that git tracks, hidden ones, too.
std::vector<std::filesystem::path> links_of_project(const std::filesystem::path& root);

/// The files of this project.
std::vector<std::filesystem::path> source_files();

}  // namespace cls::tests
