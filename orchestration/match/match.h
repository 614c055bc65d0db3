// One match from the first connection to the written result.
#pragma once

#include <atomic>

#include "base/result.h"
#include "orchestration/match/hooks/match_director.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"

namespace cls::orchestration::match {

/// The names both teams shall play under: as the options say, else from the endpoints, told apart.
TeamNames team_names(const MatchOptions& options);

/// Plays one match: starts mocks, Playmakers, foreign teams and a foreign server as the options
/// want them, connects and registers both teams, plays to the end, writes rcg, rcl, events,
/// manifest and result into the match folder, and leaves nothing running. Whatever goes wrong in
/// play is told by the result's end reason, and what was played until then is written. An error
/// means that the folder or a file in it could not be created; nothing was played then.
///
/// `director`, if there is one, arranges and watches the match besides.
/// `stop_signal` becomes nonzero (the signal's number) when the match shall end in order.
base::Result<MatchResult> run_match(const MatchOptions& options, MatchObserver& observer,
                                    const std::atomic<int>& stop_signal,
                                    MatchDirector* director = nullptr);

}  // namespace cls::orchestration::match
