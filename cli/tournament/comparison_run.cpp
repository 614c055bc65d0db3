// One run of a comparison in its folder.
#include "cli/tournament/comparison_run.h"

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "base/text/wrap_text.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/compare_progress.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/alike_matches.h"
#include "tournament/run/tournament_run.h"

namespace cls::cli {
namespace {

using namespace tournament;

int exit_code_of(const RunSummary& summary, const ComparisonVerdict& known) {
  if (known.decision == Decision::kH1) return kOk;
  if (known.decision == Decision::kH0) return kFailed;
  if (summary.end == RunEnd::kInterrupted) return signal_exit_code(summary.signal);
  return summary.end == RunEnd::kStopRequested ? kInterrupted : kUndecided;
}

void print_result(const Comparison& comparison, const std::vector<ScheduledMatch>& matches,
                  const AlikeSamples& alike, const std::filesystem::path& folder, bool json) {
  if (json) {
    fmt::print("{}", comparison_json(comparison, matches, alike.count()));
    return;
  }
  fmt::print("{}", comparison_text(comparison, matches, stdout_width()));
  if (alike.count() > 0) fmt::print("{}", base::wrap_text(alike.text() + "\n", stdout_width()));
  fmt::print("{}/\n", folder.string());
}

}  // namespace

int run_comparison(const Comparison& comparison, const std::filesystem::path& folder,
                   const SessionOptions& session, bool prints) {
  RunOptions options;
  options.folder = folder;
  options.config = comparison.config;
  options.last_match = last_match(comparison);
  options.next = [&](std::span<const ScheduledMatch> so_far) {
    return next_fixtures(comparison, so_far);
  };

  ComparisonVerdict known;
  AlikeSamples alike(comparison, folder);
  CompareProgress progress(comparison, known, stderr_is_terminal(), session.quiet);
  options.decided = [&](std::span<const ScheduledMatch> matches) {
    known = verdict(comparison, matches);
    if (const std::string line = alike.look_at(matches); !line.empty()) progress.on_note(line);
    return known.decision != Decision::kOpen;
  };

  const auto outlook_of = [&](const std::vector<ScheduledMatch>& matches) {
    const ComparisonVerdict so_far = verdict(comparison, matches);
    return Outlook{
        expected_samples_left(comparison, so_far) * matches_in_sample(comparison),
        fmt::format("{}/: {}", options.folder.string(), comparison_outlook(comparison, so_far))};
  };

  const OpenedFolder opened = begin_session(options.folder, options.config, session, outlook_of);
  if (opened.exit_code != kOk) return opened.exit_code;
  warn_of_twins(options.config, session);
  known = verdict(comparison, opened.matches);
  const auto summary =
      run_tournament(options, executors_in(options.folder), progress, watch_interrupts());
  progress.clear();
  if (!summary) return print_error(kWriteFailed, summary.error().message);

  if (prints) print_result(comparison, summary->matches, alike, folder, session.json);
  if (prints && !session.json) fmt::print("{}", watch_line(folder, summary->matches));
  const int exit_code =
      end_session(*summary, options.config, session, exit_code_of(*summary, known), false);
  if (summary->end == RunEnd::kComplete && prints && !session.quiet) {
    print_error(0, "undecided; the same command with a larger --max-pairs continues");
  }
  return exit_code;
}

}  // namespace cls::cli
