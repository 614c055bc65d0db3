// One match from the first connection to the written result.
#pragma once

#include <atomic>

#include "base/result.h"
#include "match/hooks/match_hooks.h"
#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/terms/match_options.h"

namespace cls::match {

/// Team names: from the options, otherwise derived from the endpoints and made distinct.
TeamNames team_names(const MatchOptions& options);

/// Plays one match: starts mocks, Playmakers, external teams and an external server as the options
/// ask, connects and registers both teams, plays to the end, writes rcg, rcl, events, manifest and
/// result into the match folder, and leaves no process running. Whatever fails during play becomes
/// the result's end reason, and the logs hold what was played until then. An error means that the
/// folder or a file in it could not be created; nothing was played then.
///
/// `hooks` may be null. `stop_signal` becomes nonzero (the signal's number) to end the match.
base::Result<MatchResult> run_match(const MatchOptions& options, MatchObserver& observer,
                                    const std::atomic<int>& stop_signal,
                                    MatchHooks* hooks = nullptr);

}  // namespace cls::match
