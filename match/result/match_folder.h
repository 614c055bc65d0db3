// The match folder: its path and files.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// File names inside a match folder.
inline constexpr const char* kResultFile = "result.json";
inline constexpr const char* kManifestFile = "manifest.json";
inline constexpr const char* kEventsFile = "events.jsonl";
inline constexpr const char* kGameLogFile = "match.rcg";
inline constexpr const char* kTextLogFile = "match.rcl";

/// Files with the State of a Playmaker's first error, to be sent again.
inline constexpr const char* kLeftErrorFile = "left-error.rpc";
inline constexpr const char* kRightErrorFile = "right-error.rpc";

/// True for a folder that `cls match` has begun to write.
bool is_match_folder(const std::filesystem::path& folder);

/// The game log of a match folder, plain or gzip; match.rcg if there is none yet.
std::filesystem::path game_log_in(const std::filesystem::path& folder);

/// True once the match of a folder has its result.
bool has_result(const std::filesystem::path& folder);

/// Creates the folder the options name, or ./runs/<UTC>-<left>-vs-<right> (with -2, -3, ... when
/// two matches start in the same second). Nothing is overwritten: a folder that holds something is
/// an error, or renamed to NAME.old if the options say so; the same for the file of recorded calls.
/// Only the files of a match that ended before its first cycle give way without a word.
base::Result<std::filesystem::path> make_match_folder(const MatchOptions& options,
                                                      const TeamNames& names);

/// The course of a match, for its manifest.
struct ManifestTimes {
  std::string started;           ///< UTC
  std::string ended{};           ///< empty: the match is not over
  std::string server_version{};  ///< empty: unknown
};

/// The manifest: options, versions, time, host and environment. The logs leave these out, to be
/// identical on every host.
std::string manifest_json(const MatchOptions& options, const TeamNames& names, std::uint64_t seed,
                          const ManifestTimes& times);

}  // namespace cls::match
