// Chooses what of a tournament is public, and in which order it is shown.
#include "tournament/site/spectator_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "league/matches/stage_name.h"
#include "tournament/config/start_times.h"
#include "tournament/report/report_bracket.h"
#include "tournament/report/report_tables.h"
#include "tournament/slots/timetable.h"
#include "tournament/store/pauses_file.h"

namespace cls::tournament {
namespace {

constexpr std::size_t kMaxNext = 8;

// "first round" of "first round, group A" and of "first round".
std::string stage_of(const TournamentConfig& config, const std::string& title) {
  return config.competition.stages.empty() ? title : parse_stage_name(title).stage;
}

SpectatorMatch spectator_match(const TournamentConfig& config, const ScheduledMatch& match) {
  const auto name = [&config](int team) { return config.competition.team(team); };
  SpectatorMatch shown{match.fixture.index,
                       stage_text(match.fixture),
                       name(match.fixture.left),
                       name(match.fixture.right),
                       "",
                       ""};
  if (match.outcome) {
    shown.score = match.outcome->invalid() ? "no result" : score_text(config, match);
  }
  return shown;
}

// The configured columns, or those that everyone understands.
TournamentConfig with_columns(TournamentConfig config, bool average) {
  if (!config.report.columns.empty()) return config;
  config.report.columns = {"rank", "team",  "played", "won",   "drawn",
                           "lost", "goals", "diff",   "points"};
  if (average) config.report.columns.emplace_back("average");
  return config;
}

class Viewer {
 public:
  Viewer(const TournamentState& state, const std::filesystem::path& folder)
      : state_(state), folder_(folder), report_(make_report(state.config, state.matches, folder)) {}

  SpectatorPage page() {
    page_.title = report_.name;
    page_.over = report_.complete;
    page_.status =
        fmt::format("{} of {} matches played", report_.counts.done(), report_.counts.scheduled);
    const std::vector<std::string> first = first_teams(report_);
    if (page_.over && first.size() == 1) page_.winner = first.front();
    add_pause();
    add_schedule();
    add_results();
    add_tables();
    if (!report_.bracket.empty()) page_.bracket = bracket_html(report_);
    add_statistics();
    return std::move(page_);
  }

 private:
  bool running(const ScheduledMatch& match) const {
    return std::ranges::binary_search(state_.running, match.fixture.index);
  }

  // Without its reason, which is written for the organizers.
  void add_pause() {
    const auto pauses = read_pauses(folder_);
    if (!pauses || !is_paused(*pauses)) return;
    const std::time_t begin = parse_utc_time(pauses->back().begin);
    page_.pause = "Technical time-out since " + local_time_text(begin);
  }

  void add_schedule() {
    for (const ScheduledMatch& match : state_.matches) {
      if (match.outcome) continue;
      if (running(match)) {
        page_.running.push_back(spectator_match(state_.config, match));
      } else if (page_.next.size() < kMaxNext) {
        page_.next.push_back(spectator_match(state_.config, match));
        const PlannedStart* start = find_start(report_.timetable, match.fixture.index);
        if (start != nullptr) page_.next.back().start = local_time_text(start->time);
      } else {
        ++page_.further;
      }
    }
  }

  // By stage, the latest first. The stage is the title, and what follows it the occasion.
  void add_results() {
    auto& groups = page_.results;
    for (auto match = state_.matches.rbegin(); match != state_.matches.rend(); ++match) {
      if (!match->outcome) continue;
      SpectatorMatch shown = spectator_match(state_.config, *match);
      const std::string title = stage_of(state_.config, shown.occasion);
      shown.occasion.erase(0, std::min(shown.occasion.size(), title.size() + 2));
      if (const std::string history = history_text(*match); !history.empty()) {
        shown.occasion += shown.occasion.empty() ? history : " · " + history;
      }
      auto group = std::ranges::find(groups, title, &SpectatorGroup<SpectatorMatch>::title);
      if (group == groups.end()) group = groups.insert(groups.end(), {title, {}});
      group->content.push_back(std::move(shown));
    }
  }

  // The ranks of all teams while a stage is played: those of equal places in its groups are shared,
  // which nobody can follow beside the tables of the groups.
  bool is_provisional(const RankedTable& ranked) const {
    const bool last = &ranked == &report_.tables.back();
    return last && !report_.complete && has_stages() && report_.tables.size() > 1;
  }

  bool has_stages() const { return !state_.config.competition.stages.empty(); }

  std::string table_of(const RankedTable& ranked) const {
    const TournamentConfig config = with_columns(state_.config, ranked.average);
    Report report = report_;
    report.config = &config;
    const ReportTable table = standings_table(report, ranked, Headings::kShort);
    return table.table.format_html(table.title.empty() ? "standings" : table.title);
  }

  // The last table ranks the tournament; with it come those of the stage that is played.
  void add_tables() {
    std::vector<SpectatorGroup<std::string>> groups;
    for (const RankedTable& ranked : report_.tables) {
      if (ranked.standings.empty() || is_provisional(ranked)) continue;
      const std::string title = stage_of(state_.config, ranked.title);
      if (groups.empty() || groups.back().title != title) groups.push_back({title, {}});
      groups.back().content.push_back(table_of(ranked));
    }
    const bool one = report_.complete || groups.size() < 2 || has_stages();
    const std::size_t open = one ? 1 : 2;
    for (std::size_t i = groups.size(); i > 0; --i) {
      SpectatorGroup<std::string>& group = groups[i - 1];
      if (groups.size() - i < open) {
        page_.tables.insert(page_.tables.begin(), group.content.begin(), group.content.end());
      } else {
        page_.earlier_tables.push_back(std::move(group));
      }
    }
  }

  void add_statistics();
  std::string facts_table() const;

  const TournamentState& state_;
  const std::filesystem::path& folder_;
  Report report_;
  SpectatorPage page_;
};

// Goals of a team, over the whole tournament.
struct TeamGoals {
  int matches = 0;
  int scored = 0;
  int conceded = 0;
  int clean_sheets = 0;
};

std::string per_match(int sum, int matches) {
  return matches > 0 ? fmt::format("{:.2f}", double(sum) / matches) : "–";
}

std::string result_text(const TournamentConfig& config, const ScheduledMatch& match) {
  const SpectatorMatch shown = spectator_match(config, match);
  return fmt::format("{} {} {}", shown.left, shown.score, shown.right);
}

std::string Viewer::facts_table() const {
  int matches = 0;
  int goals = 0;
  int draws = 0;
  const ScheduledMatch* widest = nullptr;
  const ScheduledMatch* richest = nullptr;
  const auto margin = [](const ScheduledMatch& match) {
    return std::abs(match.outcome->left_score - match.outcome->right_score);
  };
  const auto sum = [](const ScheduledMatch& match) {
    return match.outcome->left_score + match.outcome->right_score;
  };

  for (const ScheduledMatch& match : state_.matches) {
    if (!match.outcome || !match.outcome->played()) continue;
    ++matches;
    goals += sum(match);
    if (margin(match) == 0) ++draws;
    if (margin(match) > (widest != nullptr ? margin(*widest) : 0)) widest = &match;
    if (sum(match) > (richest != nullptr ? sum(*richest) : 0)) richest = &match;
  }

  base::Table table;
  table.add_column("tournament");
  table.add_column("");
  table.add_row({"goals", fmt::to_string(goals)});
  table.add_row({"goals a match", per_match(goals, matches)});
  table.add_row({"draws after normal time", fmt::to_string(draws)});
  if (widest != nullptr) table.add_row({"biggest win", result_text(state_.config, *widest)});
  if (richest != nullptr) table.add_row({"most goals", result_text(state_.config, *richest)});
  return table.format_html("all matches");
}

void Viewer::add_statistics() {
  std::vector<TeamGoals> teams(state_.config.competition.teams.size());
  for (const ScheduledMatch& match : state_.matches) {
    if (!match.outcome || !match.outcome->played()) continue;
    const auto add = [&](int team, int scored, int conceded) {
      TeamGoals& goals = teams[base::index(team)];
      ++goals.matches;
      goals.scored += scored;
      goals.conceded += conceded;
      if (conceded == 0) ++goals.clean_sheets;
    };
    add(match.fixture.left, match.outcome->left_score, match.outcome->right_score);
    add(match.fixture.right, match.outcome->right_score, match.outcome->left_score);
  }

  std::vector<std::size_t> order;
  for (std::size_t team = 0; team < teams.size(); ++team) {
    if (teams[team].matches > 0) order.push_back(team);
  }
  if (order.empty()) return;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return teams[a].scored * teams[b].matches > teams[b].scored * teams[a].matches;
  });

  base::Table table;
  table.add_column("team");
  for (const char* heading :
       {"matches", "goals", "per match", "against", "against per match", "clean sheets"}) {
    table.add_column(heading, base::Table::Align::kRight);
  }
  for (const std::size_t team : order) {
    const TeamGoals& goals = teams[team];
    table.add_row({state_.config.competition.teams[team].name, fmt::to_string(goals.matches),
                   fmt::to_string(goals.scored), per_match(goals.scored, goals.matches),
                   fmt::to_string(goals.conceded), per_match(goals.conceded, goals.matches),
                   fmt::to_string(goals.clean_sheets)});
  }
  page_.statistics = {facts_table(), table.format_html("goals")};
}

}  // namespace

SpectatorPage spectator_view(const TournamentState& state, const std::filesystem::path& folder) {
  return Viewer(state, folder).page();
}

}  // namespace cls::tournament
