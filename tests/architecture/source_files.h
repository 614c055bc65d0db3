// The files of the project, without what builds and package managers put beside them.
#pragma once

#include <filesystem>
#include <vector>

namespace cls::tests {

/// All regular files, sorted, except in build folders, hidden folders and those of packages.
std::vector<std::filesystem::path> source_files();

}  // namespace cls::tests
