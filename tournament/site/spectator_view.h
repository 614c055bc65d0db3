// The public view of a tournament: no endpoints, commands, hosts, latencies or messages of
// failures.
#pragma once

#include <filesystem>

#include "tournament/site/spectator_page.h"
#include "tournament/store/folder.h"

namespace cls::tournament {

/// The page without what follows from logs: SpectatorMatch::has_page and glance are not set.
SpectatorPage spectator_view(const TournamentState& state, const std::filesystem::path& folder);

}  // namespace cls::tournament
