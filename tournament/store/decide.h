// Makes decisions on matches of a tournament that is not running.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "league/matches/decision.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"
#include "tournament/store/store.h"

namespace cls::tournament {

/// The matches of the store with the decisions of the folder. Matches to be played again that still
/// have their old seed are planned in the store, and schedule.jsonl follows: a `decide` that was
/// killed has left both as they were.
base::Result<std::vector<ScheduledMatch>> decided_matches(const std::filesystem::path& folder,
                                                          Store& store);

/// The effect of a decision. Nothing was changed if there is a problem, or if it was refused.
struct DecisionEffect {
  std::string problem;             ///< there is no such match, or nothing to decide; empty: neither
  ScheduledMatch match;            ///< the match of the decision, as it counts now
  std::optional<int> drawn_again;  ///< the matches from this number on are drawn again
  int removed = 0;                 ///< number of these matches
  int removed_played = 0;          ///< of these, played already
  int awarded = 0;                 ///< kWithdraw: matches that got their result by it
  bool refused = false;            ///< because of played matches
};

/// Makes a decision on the match of its number, or on its teams; sets the seed and the result until
/// then, and of a decision on teams the number and the table. Later rounds that it changes are
/// removed, and drawn again by the next run; if some of their matches were played, only with
/// `redraw`. The caller holds the lock of the folder. An error if a file cannot be written.
base::Result<DecisionEffect> decide(const std::filesystem::path& folder,
                                    const TournamentConfig& config, MatchDecision decision,
                                    bool redraw);

}  // namespace cls::tournament
