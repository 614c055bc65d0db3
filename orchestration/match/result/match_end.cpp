// Reasons and messages that all kinds of matches share.
#include "orchestration/match/result/match_end.h"

#include <fmt/format.h>

namespace cls::orchestration::match {

using proxy::RpcOutcome;

EndReason reason_of(RpcOutcome outcome) {
  switch (outcome) {
    case RpcOutcome::kUnavailable:
      return EndReason::kCrashed;
    case RpcOutcome::kProtocolError:
    case RpcOutcome::kError:
    case RpcOutcome::kUnimplemented:
      return EndReason::kProtocolError;
    default:
      return EndReason::kLate;
  }
}

std::string describe_limit(EndReason reason, const MatchOptions& options) {
  switch (reason) {
    case EndReason::kInterrupted:
      return "interrupted";
    case EndReason::kTimedOut:
      return fmt::format("the time limit of {} s was reached", options.time_limit_s.value_or(0));
    case EndReason::kRefused:
      return fmt::format("no answer within the start limit of {} s", options.start_timeout_s);
    default:
      return fmt::format("no new cycle for {} s", options.stall_after_s);
  }
}

std::optional<MatchEnd> end_by_missing_answers(const proxy::MissingAnswers& missing,
                                               const std::string& who, int cycle,
                                               const MatchOptions& options) {
  if (missing.in_a_row <= options.max_missed) return std::nullopt;
  MatchEnd end;
  end.reason = reason_of(missing.last.outcome);
  const std::string agent = missing.unum == proxy::kCoachNumber ? "the coach"
                            : missing.unum == proxy::kTrainerNumber
                                ? "the trainer"
                                : fmt::format("player {}", missing.unum);
  end.message = fmt::format("{}: {} had no usable answer for {} cycles, at cycle {}: {}", who,
                            agent, missing.in_a_row, cycle, missing.last.message);
  return end;
}

}  // namespace cls::orchestration::match
