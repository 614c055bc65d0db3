// Lists the outcome of a match and the results before its decisions.
#include "league/matches/playing.h"

#include <algorithm>

#include "league/matches/decision.h"

namespace cls::league {

std::vector<Playing> playings_of(const ScheduledMatch& match) {
  std::vector<Playing> playings;
  const auto add = [&](const std::string& folder, const std::string& began, bool annulled) {
    const auto same = [&folder](const Playing& one) { return one.folder == folder; };
    if (folder.empty() || std::ranges::any_of(playings, same)) return;
    playings.push_back({folder, began, annulled});
  };

  if (match.outcome && match.outcome->finished()) {
    add(match.outcome->folder, match.outcome->started, match.outcome->annulled);
  }
  for (const MatchDecision& decision : match.history) add(decision.folder, decision.began, true);
  return playings;
}

}  // namespace cls::league
