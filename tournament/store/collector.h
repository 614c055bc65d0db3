// Result files of `cls tournament work` in a shared folder.
//
// Any scheduler (a Slurm job, another host, a shell loop) may play the schedule: it calls
// `cls tournament work DIR --index K` for matches of schedule.jsonl. `work` plays match K unless
// results/K.N.json (N: the attempt, `--attempt`, default 1) exists. It plays in a private folder
// below unfinished/, renames that into matches/ unless there is one of this attempt, and then
// creates the result file atomically. So a task may be killed, requeued, or run twice concurrently:
// the first result counts. An interrupted match writes no file. Only `cls tournament run` writes
// the store: it collects results/ at its start and whenever its executor polls.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "process/process_host.h"
#include "tournament/config/config.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {

/// Match and attempt in the name of a result file.
struct WorkResultName {
  int index = 0;
  int attempt = 0;
};

/// The result files of a tournament, in no particular order.
std::vector<WorkResultName> list_work_results(const std::filesystem::path& folder);

/// The outcome in the result file of an attempt. Nothing when the file is missing, corrupt or of
/// another seed.
std::optional<Outcome> read_work_result(const std::filesystem::path& folder, const Fixture& fixture,
                                        int attempt);

/// The results in results/ of those `matches` that have no outcome yet: the latest attempt of each.
/// Ignores files that are corrupt or of another seed.
std::vector<WorkResult> collect_work_results(const std::filesystem::path& folder,
                                             std::span<const ScheduledMatch> matches);

/// Plays one attempt at a match in a child process and writes its result file. Returns nothing when
/// `stop_signal` stopped it, and the outcome on file when there is one already. An error when the
/// match could not be played, or the file could not be written.
base::Result<std::optional<Outcome>> work(const std::filesystem::path& folder,
                                          const Fixture& fixture, int attempt,
                                          const std::filesystem::path& program,
                                          const std::atomic<int>& stop_signal);

}  // namespace cls::tournament
