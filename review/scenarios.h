// Moments of decisions as scenarios of `cls test`.
#pragma once

#include <string>

#include "base/text/json.h"
#include "gamelog/record/match_record.h"
#include "review/verdict.h"

namespace cls::review {

/// What the scenario of a decision says beside its moment.
struct ScenarioTerms {
  std::string match;      ///< in its text
  std::string playmaker;  ///< of the side of the decision, which is under test
  int steps = 50;
};

/// The scenario (docs/testing.md) that starts where the player decided, against the bundled
/// planner. It expects the side of the decision to have the ball at its end in most runs, and no
/// goal against it.
base::Json scenario_of(const gamelog::MatchRecord& record, const Verdict& verdict,
                       const ScenarioTerms& terms);

}  // namespace cls::review
