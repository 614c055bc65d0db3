// The view of organizers: all matches with their states, and the tables.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "tournament/store/folder.h"
#include "viewer/live/match_list.h"

namespace cls::tournament {

/// The moment when a list was first asked for, and how many matches were done then.
using FirstLook = std::pair<std::chrono::steady_clock::time_point, int>;

/// The list without what follows from the logs of running matches. `first_look` is set if it is
/// not; how long the rest takes follows from it.
viewer::MatchList organizer_view(const TournamentState& state, const std::filesystem::path& folder,
                                 std::optional<FirstLook>& first_look);

/// The folder of a match, also while it is played.
std::filesystem::path folder_of(const TournamentState& state, const ScheduledMatch& match,
                                const std::filesystem::path& tournament);

}  // namespace cls::tournament
