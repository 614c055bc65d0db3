// What `cls tournament work` left on a shared folder, and how it gets there.
//
// The seam for matches that are played elsewhere: whoever plays the schedule (a job of Slurm, a
// second machine on the same folder, a loop in a shell) calls `cls tournament work DIR --index K`
// for matches of schedule.jsonl. `work` plays match K unless results/K.N.json (N: the attempt,
// `--attempt`, 1 by default) is there already. It plays in a folder of its own below unfinished/,
// gives that its name below matches/ by a rename, and then makes the result file in one step: so a
// task may be killed, requeued, or run twice at once, and the first one counts. A match that was
// interrupted leaves no file. Only one process, `cls tournament run`, writes the store: it takes up
// what lies in results/ with collect_results when it starts, and whenever its executor looks.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "orchestration/process/process_host.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

struct Delivery {
  int index = 0;
  Outcome outcome;
};

/// Name of a result file: match and attempt.
struct ResultName {
  int index = 0;
  int attempt = 0;
};

/// All result files of a tournament by their names, in no order.
std::vector<ResultName> result_names(const std::filesystem::path& folder);

/// The outcome in the result file of an attempt. Nothing when there is none, or one that is not
/// whole or of another seed.
std::optional<Outcome> read_result(const std::filesystem::path& folder, const Fixture& fixture,
                                   int attempt);

/// The outcomes in results/ of those of `matches` that have none yet: of several attempts the
/// latest. Files that are not whole, or of another seed, are passed over.
std::vector<Delivery> collect_results(const std::filesystem::path& folder,
                                      std::span<const ScheduledMatch> matches);

/// `work`: plays one attempt at a match in a process of its own and leaves its result file.
/// Nothing when `stop_signal` ended it. An error when the match could not be played at all, or the
/// file could not be written. Returns the outcome on file when there is one already.
base::Result<std::optional<Outcome>> work(const std::filesystem::path& folder,
                                          const Fixture& fixture, int attempt,
                                          const std::filesystem::path& program,
                                          const std::atomic<int>& stop_signal);

}  // namespace cls::orchestration::tournament
