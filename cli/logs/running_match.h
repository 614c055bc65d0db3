// Matches that are played now: in a folder, in a log, on a server.
#pragma once

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

/// True for HOST:PORT, unless there is a file of that name.
bool names_server(const std::string& what);

}  // namespace cls::cli
