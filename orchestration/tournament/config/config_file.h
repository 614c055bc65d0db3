// cls.toml: finding, reading and writing it, and where two configurations differ.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/config/config.h"

namespace cls::orchestration::tournament {

inline constexpr const char* kConfigFile = "cls.toml";

/// A configuration with all that is wrong with it, one line each: "cls.toml:12: unknown key
/// 'ronds'; did you mean 'rounds'?". The configuration is whole only without mistakes.
struct ConfigReading {
  TournamentConfig config;
  std::vector<std::string> mistakes;
};

/// Reads the text of a file; `file` is its name in messages. Only the form is checked here and
/// that words and values are known; mistakes_in() checks the whole.
ConfigReading parse_config(std::string_view text, const std::string& file);

/// Reads a file; `folder` of the configuration is made absolute, the file's own folder by default.
ConfigReading read_config(const std::filesystem::path& file);

/// cls.toml in `from` or the nearest folder above it.
std::optional<std::filesystem::path> find_config(const std::filesystem::path& from);

/// An endpoint whose relative paths start in `folder`, for use in the working directory: unchanged
/// when that is the same folder.
std::string endpoint_from(const std::filesystem::path& folder, const std::string& endpoint);

/// The configuration as a file that reads back as the same. `plan_only` leaves out what may change
/// from run to run.
std::string config_text(const TournamentConfig& config, bool plan_only = false);

/// The first line in which the plans of two configurations differ, such as "rounds is 1, was 2";
/// empty when they are the same.
std::string first_difference(const TournamentConfig& now, const TournamentConfig& before);

/// A commented file for `cls init`: every key with its meaning and default, two mock teams.
std::string commented_config();

}  // namespace cls::orchestration::tournament
