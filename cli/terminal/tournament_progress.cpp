// Progress of a tournament on stderr.
#include "cli/terminal/tournament_progress.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/text/counted.h"
#include "base/text/printable.h"
#include "league/schedule/schedule.h"
#include "tournament/report/report_model.h"

namespace cls::cli {

using namespace tournament;

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

std::string match_line(const TournamentConfig& config, const ScheduledMatch& match, int total) {
  const Outcome& outcome = *match.outcome;

  const auto team = [&](int index) { return std::string_view(config.competition.team(index)); };

  std::string how = fmt::format("{}, {:.1f} s", name(outcome.end_reason), outcome.run_seconds);
  if (const std::size_t count = outcome.warnings.size(); count > 0) {
    how += ", " + base::counted(count, "warning");
  }

  std::string line = fmt::format(
      "match {}/{}  {} {} {}  ({})", match.fixture.index, total, team(match.fixture.left),
      outcome.counts() ? score_text(config, match) : "-", team(match.fixture.right), how);
  if (!outcome.finished() && !outcome.message.empty()) line += ": " + outcome.message;
  return line;
}

std::string TournamentProgress::status(const RunProgress& progress) const {
  return progress_text(progress) + (leader_.empty() ? "" : "  " + leader_);
}

void TournamentProgress::resume(const TournamentConfig& config,
                                const std::vector<ScheduledMatch>& matches) {
  for (const ScheduledMatch& match : matches) {
    if (match.outcome) played_.push_back(match);
  }
  find_leader(config);
}

// The tables of thousands of matches take longer than a match: not after each of them.
void TournamentProgress::find_leader(const TournamentConfig& config) {
  constexpr std::size_t kFew = 200;
  const Clock::time_point now = Clock::now();
  if (played_.size() > kFew && now - last_leader_ < std::chrono::seconds(10)) return;
  last_leader_ = now;

  const std::vector<RankedTable> ranked = tables(config.competition, played_);
  if (ranked.empty() || ranked.back().standings.empty()) return;
  const std::vector<Standing>& rows = ranked.back().standings;
  const bool alone = rows.front().points > 0 && (rows.size() == 1 || rows[1].rank > 1);
  const auto team = static_cast<std::size_t>(rows.front().team);
  leader_ = alone ? config.competition.teams[team].name + " leads" : "";
}

bool TournamentProgress::is_due(const RunProgress& /*progress*/, Clock::duration since_last) {
  return since_last >= std::chrono::minutes(1);
}

void TournamentProgress::print(std::string_view line) {
  if (quiet_) return;
  clear();
  fmt::print(stderr, "{}\n", base::printable(line));
  std::fflush(stderr);
}

void TournamentProgress::on_progress(const RunProgress& progress) {
  if (quiet_) return;
  if (on_terminal_) return line_.show(status(progress));

  const Clock::time_point now = Clock::now();
  if (!is_due(progress, now - last_status_)) return;
  last_status_ = now;
  print(status(progress));
}

void TournamentProgress::on_match(const TournamentConfig& config, const ScheduledMatch& match,
                                  const RunProgress& progress) {
  print(match_line(config, match, progress.total));
  played_.push_back(match);
  find_leader(config);
  on_progress(progress);
}

void TournamentProgress::on_note(std::string_view line) { print(fmt::format("cls: {}", line)); }

}  // namespace cls::cli
