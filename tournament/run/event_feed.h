// Passes the events of matches to the command on_event.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "base/text/json.h"
#include "league/matches/fixture.h"
#include "process/hook_runner.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// Matches append their events to one file of the tournament, wherever they are played. This reads
/// the file and adds tournament, match and stage. Without on_event it does nothing.
class EventFeed {
 public:
  /// Reads what is written from now on, so that no event is passed on twice.
  EventFeed(const TournamentConfig& config, std::filesystem::path folder);

  /// Passes on the events that came since the last call.
  void poll(std::span<const ScheduledMatch> matches, process::HookRunner& hooks);

  /// An outcome was recorded. Passes on a failure that the match has not reported itself: one that
  /// was killed does not.
  void settle(std::span<const ScheduledMatch> matches, const ScheduledMatch& match,
              process::HookRunner& hooks);

 private:
  void pass_on(base::Json event, const ScheduledMatch& match, process::HookRunner& hooks);

  const TournamentConfig& config_;
  std::filesystem::path folder_;
  std::uint64_t position_ = 0;
  std::set<int> ended_;  // matches that have reported an end which is not settled
};

}  // namespace cls::tournament
