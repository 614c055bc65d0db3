// The match folder: its path and files.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "orchestration/match/options/match_options.h"

namespace cls::orchestration::match {

/// File names inside a match folder.
inline constexpr const char* kResultFile = "result.json";
inline constexpr const char* kManifestFile = "manifest.json";
inline constexpr const char* kEventsFile = "events.jsonl";
inline constexpr const char* kGameLogFile = "match.rcg";
inline constexpr const char* kTextLogFile = "match.rcl";

/// Creates the folder the options name, or ./runs/<UTC>-<left>-vs-<right> (with -2, -3, ... when
/// two matches start in the same second). An existing folder is used; files of an earlier match
/// in it are replaced.
base::Result<std::filesystem::path> make_match_folder(const MatchOptions& options,
                                                      const TeamNames& names);

/// The manifest: options, time and host. The logs leave these out, to be identical on every host.
std::string manifest_json(const MatchOptions& options, const TeamNames& names, std::uint64_t seed);

}  // namespace cls::orchestration::match
