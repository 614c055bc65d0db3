// How a match came to its end, and the words for it.
#pragma once

#include <optional>
#include <string>

#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/end_reason.h"
#include "orchestration/match/result/match_result.h"
#include "proxy/agent/team.h"

namespace cls::orchestration::match {

struct MatchEnd {
  EndReason reason = EndReason::kFinished;
  std::string message;  ///< one line; empty when finished
  std::optional<ProcessFailure> failure;
};

/// What a Playmaker without usable answers is told to have done.
EndReason reason_of(proxy::RpcOutcome outcome);

/// The words for a limit that was exceeded (DeadlineWatch).
std::string describe_limit(EndReason reason, const MatchOptions& options);

/// The end that missing answers make, when they are more than the options allow. `who` names team
/// and endpoint.
std::optional<MatchEnd> end_by_missing_answers(const proxy::MissingAnswers& missing,
                                               const std::string& who, int cycle,
                                               const MatchOptions& options);

}  // namespace cls::orchestration::match
