// Paths that hold something already: what it is, and how to keep it under another name.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace cls::base {

/// The contents of a folder, for messages: "match.rcg, result.json and 4 more". Empty when the
/// folder is empty or missing.
std::string contents_of(const std::filesystem::path& folder);

/// Renames an existing file or folder to NAME.old, NAME.old2, ...; returns the new name.
Result<std::filesystem::path> set_aside(const std::filesystem::path& path);

}  // namespace cls::base
