// A row for each match, and facts about all of them.
#include "tournament/site/organizer_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "match/result/match_folder.h"
#include "tournament/report/report_model.h"
#include "tournament/report/report_tables.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

constexpr double kShortlySeconds = 60.0;

void add_table(const ReportTable& table, viewer::MatchList& list) {
  if (!table.empty()) list.tables.push_back(table.table.format_html(table.title));
}

// The first lines of the page.
std::vector<viewer::Fact> facts(const Report& report, std::size_t running) {
  const MatchCounts& counts = report.counts;

  int goals = 0;
  int counted = 0;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome || !match.outcome->counts()) continue;
    goals += match.outcome->left_score + match.outcome->right_score;
    ++counted;
  }

  const auto& ranked = report.tables;
  const bool leads = counted > 0 && !ranked.empty() && !ranked.back().standings.empty();
  const std::string waiting = fmt::to_string(counts.open - static_cast<int>(running));
  return {{report.complete ? "winner" : "leader",
           leads ? report.team(ranked.back().standings.front().team) : "–"},
          {"matches done", fmt::format("{} of {}", counts.done(), counts.scheduled)},
          {"played now", fmt::to_string(running)},
          {"still to play", waiting},
          {"goals a match", counted > 0 ? fmt::format("{:.1f}", double(goals) / counted) : "–"}};
}

// "4 of 6 matches done, 2 played now, about 3 min left".
std::string status(const Report& report, std::size_t running, const FirstLook& first_look) {
  std::string text = counts_text(report.counts);
  if (running > 0) text += fmt::format(", {} played now", running);

  const auto& [begin, done_before] = first_look;
  const int done = report.counts.done();
  if (running == 0 || done <= done_before) return text;

  const double seconds = std::chrono::duration<double>(steady_clock::now() - begin).count() *
                         report.counts.open / (done - done_before);
  return text + (seconds < kShortlySeconds
                     ? ", less than a minute left"
                     : fmt::format(", about {:.0f} min left", seconds / 60.0));
}

viewer::ListedMatch row(const TournamentState& state, const ScheduledMatch& match,
                        const fs::path& folder) {
  const Competition& competition = state.config.competition;
  viewer::ListedMatch row{match.fixture.index,
                          competition.team(match.fixture.left),
                          competition.team(match.fixture.right),
                          "",
                          "",
                          false};

  std::error_code code;
  const bool running = std::ranges::binary_search(state.running, match.fixture.index);
  row.has_page = (running || match.attempts > 0) &&
                 fs::exists(match::game_log_in(folder_of(state, match, folder)), code);

  if (!match.outcome) {
    row.state = running ? "starting" : match.attempts > 0 ? "not finished" : "planned";
    row.live = true;
  } else {
    row.score = fmt::format("{} : {}", match.outcome->left_score, match.outcome->right_score);
    row.state = match.outcome->forfeit ? "forfeited" : "finished";
    if (match.outcome->annulled) row.state = "annulled";
    if (match.outcome->invalid()) row.state = "failed: " + match.outcome->message;
    row.has_page = row.has_page && !match.outcome->folder.empty();
  }
  return row;
}

}  // namespace

fs::path folder_of(const TournamentState& state, const ScheduledMatch& match,
                   const fs::path& tournament) {
  if (match.outcome && !match.outcome->folder.empty()) return tournament / match.outcome->folder;
  return tournament / match_folder(state.config, match.fixture, std::max(1, match.attempts));
}

viewer::MatchList organizer_view(const TournamentState& state, const fs::path& folder,
                                 std::optional<FirstLook>& first_look) {
  const Report report = make_report(state.config, state.matches, folder);
  if (!first_look) first_look = {steady_clock::now(), report.counts.done()};

  viewer::MatchList list;
  list.title = report.name;
  list.status = status(report, state.running.size(), *first_look);
  list.running = !report.complete;
  list.facts = facts(report, state.running.size());
  for (const RankedTable& ranked : report.tables) {
    add_table(standings_table(report, ranked, Headings::kShort), list);
  }
  add_table(crosstable(report, false), list);
  for (const ScheduledMatch& match : state.matches) {
    list.matches.push_back(row(state, match, folder));
  }
  return list;
}

}  // namespace cls::tournament
