// Reads and writes small files as a whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::base {

/// All bytes of a file; nothing if it does not exist, is a folder or is not readable.
std::optional<std::string> read_file(const std::filesystem::path& path);

/// As read_file(), without a byte order mark at its begin: for texts that users write.
std::optional<std::string> read_text(const std::filesystem::path& path);

/// Writes a file atomically (Replacement); devices, pipes and links are written into. The error
/// names the file and the cause.
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes);

/// Writes a whole file so that it has the old bytes or the new ones even after a power cut.
Result<void> write_file_durably(const std::filesystem::path& path, std::string_view bytes);

/// Why `path` cannot be used: "no such file", "Permission denied", ...; nothing if it exists.
std::optional<std::string> absence(const std::filesystem::path& path);

/// Why `path` is not a readable file: "no such file", "a folder, not a file", ...; nothing if it is
/// one.
std::optional<std::string> why_no_file(const std::filesystem::path& path);

/// Why `path` is not a folder: "no such folder", "a file, not a folder"; nothing if it is one.
std::optional<std::string> why_no_folder(const std::filesystem::path& path);

/// Creates a folder and those above it; succeeds if it exists. The error names the folder and the
/// cause.
Result<void> create_folders(const std::filesystem::path& folder);

}  // namespace cls::base
