// Moments of decisions as scenarios of `cls test`.
#pragma once

#include <string>

#include "base/text/json.h"
#include "gamelog/record/match_record.h"
#include "review/verdict.h"

namespace cls::review {

/// The scenario (docs/testing.md) that starts where the player decided, with the bundled planner on
/// both sides and the side of the decision under test. It expects this side to have the ball at the
/// end of the playout in most runs, and no goal against it. `match` names the match in its text.
base::Json scenario_of(const gamelog::MatchRecord& record, const Verdict& verdict,
                       const std::string& match, const PlayoutTerms& terms);

}  // namespace cls::review
