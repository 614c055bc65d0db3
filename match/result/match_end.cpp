// Messages and failures of processes and Playmakers.
#include "match/result/match_end.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "base/system/control_group.h"
#include "base/text/byte_size.h"
#include "match/terms/run_command.h"
#include "proxy/playmaker/playmaker_errors.h"

namespace cls::match {
namespace {

using proxy::RpcOutcome;

EndReason reason_of(RpcOutcome outcome) {
  if (outcome == RpcOutcome::kUnavailable) return EndReason::kCrashed;
  const bool wrong = outcome == RpcOutcome::kProtocolError || outcome == RpcOutcome::kError ||
                     outcome == RpcOutcome::kUnimplemented;
  return wrong ? EndReason::kProtocolError : EndReason::kLate;
}

std::string format_exit(const process::Child::Status& status) {
  if (!status.exit) return "running";
  return status.asked_to_end ? fmt::format("ended by cls ({})", to_text(*status.exit))
                             : to_text(*status.exit);
}

// By SIGKILL, itself or as the command of a shell.
bool was_killed(const process::Child::Status& status) {
  constexpr int kShellSignals = 128;
  if (!status.exit || status.asked_to_end) return false;
  return status.exit->number == (status.exit->by_signal ? SIGKILL : kShellSignals + SIGKILL);
}

// Texts of programs that get no memory: C, C++, Python, Java, JavaScript, Go and Rust, dd.
constexpr std::string_view kOutOfMemory[] = {
    "Cannot allocate memory", "bad_alloc",     "MemoryError",       "OutOfMemoryError",
    "out of memory",          "Out of memory", "memory allocation", "memory exhausted"};

}  // namespace

bool prints_any(const process::Child& child, std::span<const std::string_view> texts) {
  return std::ranges::any_of(child.last_lines(), [texts](const std::string& line) {
    return std::ranges::any_of(
        texts, [&](std::string_view text) { return line.find(text) != std::string::npos; });
  });
}

std::string limit_hint(const process::Child& child) {
  const process::ResourceLimits& limits = child.plan().limits;
  if (child.status().at_cpu_limit) {
    return fmt::format(
        "; a process of {} had used the {} s of CPU time that --max-cpu allows: raise or omit the "
        "limit",
        child.plan().name, limits.cpu_seconds);
  }

  const process::Child::Status status = child.status();
  const std::string killed = was_killed(status) ? base::memory_kill_text() : std::string();
  if (!killed.empty()) return "; " + killed;

  if (limits.memory != 0 && prints_any(child, kOutOfMemory)) {
    return fmt::format(
        "; a process of {} needed more than the {} of memory that --max-memory allows: raise or "
        "omit the limit",
        child.plan().name, base::byte_size_text(limits.memory));
  }
  return {};
}

ProcessFailure failure_of(const process::Child& child) {
  return {.process = child.plan().name,
          .exit = format_exit(child.status()),
          .log = child.plan().log.filename().string(),
          .output = child.last_lines()};
}

ProcessFailure playmaker_failure(soccer::Side side) { return {.process = playmaker_name(side)}; }

std::string describe(const proxy::AwaitedCall& call) {
  std::string text = fmt::format("{} of {}", name(call.rpc), proxy::agent_name(call.agent));
  if (call.others == 1) text += " and 1 other agent";
  if (call.others > 1) text += fmt::format(" and {} other agents", call.others);
  if (call.others > 0) text += " (one call; --batch never names the player)";
  return text;
}

ProcessResult result_of(const process::Child& child) {
  ProcessResult result;
  result.name = child.plan().name;
  result.command = process::to_shell(child.plan());
  result.log = child.plan().log.filename().string();
  result.exit = format_exit(child.status());
  result.cpu_seconds = child.cpu_seconds();
  result.delayed_seconds = child.delayed_seconds();
  result.log_error = child.log_error();
  return result;
}

std::optional<MatchEnd> end_by_missed_decisions(const proxy::MissedDecisions& missed,
                                                const std::string& who, int cycle,
                                                const MatchOptions& options) {
  if (missed.consecutive <= options.max_missed) return std::nullopt;
  MatchEnd end;
  end.reason = reason_of(missed.last.outcome);
  end.message =
      fmt::format("{}: {} had no usable reply to {} calls in a row, at cycle {}: {}", who,
                  proxy::agent_name(missed.unum), missed.consecutive, cycle, missed.last.message);
  return end;
}

}  // namespace cls::match
