// `cls watch TOURNAMENT_DIR`: a list of the matches, and the page of each.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/logs/live_view.h"

namespace cls::cli {

/// Serves the matches of a tournament: those that are played now follow their logs, the others are
/// replays. Returns an exit code after a signal, or when the time of LiveViewOptions::linger_s has
/// passed since the last match. `on_start` receives the address.
int serve_tournament(const std::filesystem::path& folder, const LiveViewOptions& options,
                     const std::function<void(const std::string& url)>& on_start);

}  // namespace cls::cli
