// Matches that are played now: in a folder, in a log, on a server.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "cli/logs/live_view.h"

namespace cls::cli {

/// The running match that `what` means: a folder that find_match_folder() knows, if its match has
/// no result and its log has grown lately; HOST:PORT of a soccer server; a log if `is_live_log`
/// says that a server writes it. Nothing: `what` is a match that is over, or none. The error says
/// why it cannot be followed.
base::Result<std::optional<FollowedMatch>> find_running_match(const std::string& what,
                                                              bool is_live_log);

/// The game log of a match folder, plain or gzip; match.rcg if there is none yet.
std::filesystem::path game_log_in(const std::filesystem::path& folder);

/// True once the match of a folder has its result.
bool has_result(const std::filesystem::path& folder);

}  // namespace cls::cli
