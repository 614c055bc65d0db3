// Finds the logs that command arguments refer to, and pairs game logs with text logs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::gamelog {

/// A folder with a file of this name has logs that are not results: copies, or trials. find_logs()
/// does not look for logs there on its way through a folder above it.
inline constexpr const char* kApartMark = ".apart";

/// Creates `folder` with that file.
base::Result<void> set_apart(const std::filesystem::path& folder);

/// The logs of one match. One of them may be empty; "-" is standard input.
struct MatchLogs {
  std::string game;  ///< rcg
  std::string text;  ///< rcl
};

struct FoundLogs {
  std::vector<MatchLogs> matches;    ///< in the order of the arguments; inside a folder by name
  std::vector<std::string> missing;  ///< arguments without any log
};

/// The path without .gz, .xz or .zst, which base::open_source() unpacks.
std::string_view unpacked_name(std::string_view path);

/// True for .rcl, also with .gz, .xz or .zst.
bool is_text_log(std::string_view path);

/// A file is a game log unless it is a text log. A folder stands for all logs in and below it
/// (.rcg, .rcl, also with .gz, .xz or .zst). A pattern with * ? [ stands for the paths that it
/// matches, unless a file has that name. Logs that differ only in the extension belong to one
/// match, unless two of one kind have different bytes when they are unpacked: then each is a match.
/// The text log next to a game log is found automatically.
FoundLogs find_logs(const std::vector<std::string>& arguments);

}  // namespace cls::gamelog
