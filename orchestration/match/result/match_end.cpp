// Messages and failures of processes and Playmakers.
#include "orchestration/match/result/match_end.h"

#include <fmt/format.h>

namespace cls::orchestration::match {
namespace {

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

std::string format_exit(const process::Child::Status& status) {
  if (!status.exit) return "running";
  return status.asked_to_end ? fmt::format("ended by cls ({})", to_text(*status.exit))
                             : to_text(*status.exit);
}

std::string format_agent(int number) {
  if (number == proxy::kCoachNumber) return "the coach";
  if (number == proxy::kTrainerNumber) return "the trainer";
  return fmt::format("player {}", number);
}

}  // namespace

ProcessFailure failure_of(const process::Child& child) {
  return {child.plan().name, format_exit(child.status()), child.plan().log.filename().string(),
          child.last_lines()};
}

ProcessResult result_of(const process::Child& child) {
  return {child.plan().name, process::to_shell(child.plan()), child.plan().log.filename().string(),
          format_exit(child.status()), child.cpu_seconds()};
}

std::optional<MatchEnd> end_by_missed_decisions(const proxy::MissedDecisions& missed,
                                                const std::string& who, int cycle,
                                                const MatchOptions& options) {
  if (missed.consecutive <= options.max_missed) return std::nullopt;
  MatchEnd end;
  end.reason = reason_of(missed.last.outcome);
  end.message =
      fmt::format("{}: {} had no usable reply for {} cycles, at cycle {}: {}", who,
                  format_agent(missed.unum), missed.consecutive, cycle, missed.last.message);
  return end;
}

}  // namespace cls::orchestration::match
