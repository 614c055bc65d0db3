// Progress of a tournament on a terminal.
#include "cli/terminal/tournament_progress.h"

#include <fmt/format.h>

#include "orchestration/tournament/report/report_text.h"

namespace cls::cli {

using orchestration::tournament::RunProgress;

std::string progress_text(const RunProgress& progress) {
  std::string text = fmt::format(
      "{} {}/{} matches  {} running",
      progress_bar(progress.total > 0 ? static_cast<double>(progress.done) / progress.total : 0.0),
      progress.done, progress.total, progress.running);
  if (progress.invalid > 0) text += fmt::format("  {} invalid", progress.invalid);
  if (progress.done_in_this_run > 0 && progress.seconds > 0) {
    const double rate = progress.done_in_this_run / progress.seconds;
    text += fmt::format("  {:.1f} a minute  {}", rate * 60,
                        time_left((progress.total - progress.done) / rate));
  }
  return text;
}

void TournamentProgress::on_progress(const RunProgress& progress) {
  if (shown_) line_.show(progress_text(progress));
}

void TournamentProgress::on_match(const orchestration::tournament::TournamentConfig& config,
                                  const orchestration::tournament::ScheduledMatch& match,
                                  const RunProgress& progress) {
  if (!shown_) return;
  clear();
  fmt::print(stderr, "{:>6}  {} - {}  {}\n", match.fixture.index,
             config.teams[static_cast<std::size_t>(match.fixture.left)].name,
             config.teams[static_cast<std::size_t>(match.fixture.right)].name,
             orchestration::tournament::score_text(match));
  on_progress(progress);
}

void TournamentProgress::on_note(std::string_view line) {
  if (quiet_) return;
  clear();
  fmt::print(stderr, "cls: {}\n", line);
}

}  // namespace cls::cli
