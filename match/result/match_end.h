// Why a match ended, and reports on the processes that took part in it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "match/result/match_result.h"
#include "match/terms/match_options.h"
#include "process/process_host.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/call_watch.h"
#include "soccer/end_reason.h"

namespace cls::match {

/// A process that is asked to exit may take this long before SIGKILL. An interrupted match must
/// end within 5 s.
inline constexpr std::chrono::milliseconds kTerminateGrace{1000};
/// Extra time for a killed process to disappear.
inline constexpr std::chrono::milliseconds kKillMargin{300};

struct MatchEnd {
  EndReason reason = EndReason::kFinished;
  std::string message{};                    ///< one line; empty when finished
  std::optional<ProcessFailure> failure{};  ///< the process that caused it
  std::optional<soccer::Side> fault{};      ///< the side that caused it
  bool fault_unknown = false;               ///< the side that failed may be the victim
  bool try_again = false;                   ///< a port was in use: nothing was started
};

/// True if a line of the last output of a program contains one of the texts.
bool prints_any(const process::Child& child, std::span<const std::string_view> texts);

/// To be appended to the message about a process that failed: "; a process of left Playmaker had
/// used the 10 s of CPU time that --max-cpu allows: raise or omit the limit". Empty if no limit
/// explains the end.
/// The kernel reports the end by the limit of CPU time. A program that gets no more memory ends in
/// its own way: then the hint follows from its last output lines.
std::string limit_hint(const process::Child& child);

/// Exit status and last output lines of a child that has exited or will be terminated.
ProcessFailure failure_of(const process::Child& child);

/// The report on a Playmaker that cls did not start.
ProcessFailure playmaker_failure(soccer::Side side);

/// "GetPlayerActions of player 3 and 8 other agents".
std::string describe(const proxy::AwaitedCall& call);

/// The entry in result.json's list of processes; reads the CPU time.
ProcessResult result_of(const process::Child& child);

/// The end caused by missed decisions, if there are more in a row than the options allow. `who`
/// names team and endpoint.
std::optional<MatchEnd> end_by_missed_decisions(const proxy::MissedDecisions& missed,
                                                const std::string& who, int cycle,
                                                const MatchOptions& options);

}  // namespace cls::match
