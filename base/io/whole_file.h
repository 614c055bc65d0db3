// Reading and writing a small file at once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// All bytes of a file; nothing where there is none, or a folder, or no right to read it.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// Writes a whole file by way of a temporary one beside it and a rename, so that a reader never
/// sees half of it. The error names the file and the reason.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cls::base
