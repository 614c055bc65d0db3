// Finds, reads and writes cls.toml, and compares configurations.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "tournament/config/config.h"

namespace cls::tournament {

inline constexpr const char* kConfigFile = "cls.toml";

/// A configuration and its errors, one line each: "cls.toml:12: unknown key 'ronds'; did you mean
/// 'rounds'?". The configuration is complete only without errors.
struct ParsedConfig {
  TournamentConfig config;
  std::vector<std::string> errors;
  std::map<std::string, int> lines;  ///< of keys in the file: "cycles", "server::half_time"
};

/// Parses the text of a file; `file` is its name in messages. Checks keys, types and names only;
/// validate() checks the whole.
ParsedConfig parse_config(std::string_view text, const std::string& file);

/// Reads a file and makes `folder` of the configuration absolute (default: the file's folder).
ParsedConfig read_config(const std::filesystem::path& file);

/// cls.toml in `from` or the nearest folder above it.
std::optional<std::filesystem::path> find_config(const std::filesystem::path& from);

/// An endpoint with paths relative to `folder`, for use in the working directory; unchanged when
/// both are the same folder.
std::string endpoint_from(const std::filesystem::path& folder, const std::string& endpoint);

/// The configuration as TOML that parses to the same configuration. `plan_only` omits values that
/// may change from run to run.
std::string format_config(const TournamentConfig& config, bool plan_only = false);

/// The first difference of the plans of two configurations, such as "rounds is 1, was 2"; empty
/// when they are equal.
std::string first_difference(const TournamentConfig& now, const TournamentConfig& before);

/// A commented file for `cls init`: every key with its meaning and default, two mock teams.
std::string commented_config();

}  // namespace cls::tournament
