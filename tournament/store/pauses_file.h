// pauses.jsonl: technical time-outs of a tournament, a line each, which gets its end later.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

inline constexpr const char* kPausesFile = "pauses.jsonl";

/// A technical time-out: no match starts, and running ones are played to their end.
struct Pause {
  std::string begin;  ///< UTC, ISO 8601
  std::string end;    ///< empty: the tournament is paused
  std::string reason;
};

/// All of a tournament, in the order of time. An error names a line that cannot be read.
base::Result<std::vector<Pause>> read_pauses(const std::filesystem::path& folder);

/// True when the last one has not ended.
bool is_paused(const std::vector<Pause>& pauses);

/// Begins a time-out, or ends the current one. They do nothing, and return false, when the
/// tournament is paused already, or not paused.
base::Result<bool> begin_pause(const std::filesystem::path& folder, const std::string& reason);
base::Result<bool> end_pause(const std::filesystem::path& folder);

}  // namespace cls::tournament
