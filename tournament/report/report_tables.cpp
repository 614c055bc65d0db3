// Columns and rows of the report tables.
#include "tournament/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "base/text/counted.h"
#include "base/text/percent_encoding.h"
#include "base/text/printable.h"
#include "tournament/config/start_times.h"
#include "tournament/report/standings_columns.h"

namespace cls::tournament {
namespace {

using Align = base::Table::Align;

std::string percent(double share) { return fmt::format("{:.1f}", 100 * share); }

std::string interval(const Interval& shares) {
  return fmt::format("{}..{}", percent(shares.low), percent(shares.high));
}

std::string superiority(double likelihood) { return percent(likelihood) + " %"; }

std::string sample_text(const HeadToHead& head_to_head) {
  if (!head_to_head.paired()) return base::counted(head_to_head.games.games(), "match", "matches");
  std::string text = base::counted(static_cast<int>(total(head_to_head.pairs)), "pair", "pairs");
  if (head_to_head.single_games > 0)
    text += fmt::format(", not {} single", head_to_head.single_games);
  return text;
}

std::string record_text(const WinDrawLoss& record) {
  return fmt::format("{}-{}-{}", record.won, record.drawn, record.lost);
}

// "1-0-0", "1-0-0 f+1" with a win by forfeit, "f-2" with nothing but two losses by forfeit.
std::string crosstable_cell(const HeadToHead& head_to_head) {
  const WinLoss& forfeits = head_to_head.forfeits;
  std::string text = head_to_head.games.games() > 0 ? record_text(head_to_head.games) : "";
  if (!forfeits.any()) return text;
  text += text.empty() ? "f" : " f";
  if (forfeits.won > 0) text += fmt::format("+{}", forfeits.won);
  if (forfeits.lost > 0) text += fmt::format("-{}", forfeits.lost);
  return text;
}

std::string goals_text(const HeadToHead& head_to_head) {
  std::string text = fmt::format("{}:{}", head_to_head.goals_for, head_to_head.goals_against);
  const WinLoss& shoot_outs = head_to_head.shoot_outs;
  if (shoot_outs.any()) text += fmt::format(" (pen {}-{})", shoot_outs.won, shoot_outs.lost);
  return text;
}

std::string milliseconds(double microseconds) { return fmt::format("{:.1f}", microseconds / 1000); }

// "2026-11-22 10:35:12" of ISO 8601.
std::string time_text(const std::string& iso) {
  std::string text = iso.substr(0, iso.find('Z'));
  std::ranges::replace(text, 'T', ' ');
  return text;
}

// Links to `file` in the folder of a match; "" is the folder.
void link_folder(const Report& report, const ScheduledMatch& match, const char* file,
                 std::size_t column, base::Table& table) {
  if (!match.outcome || match.outcome->folder.empty()) return;
  const auto path = (report.link_base / match.outcome->folder / file).lexically_normal();
  table.link_last_row(column, base::percent_encoded(path.string()));
}

std::string tiebreaker_note(const Report& report, const RankedTable& ranked) {
  std::string text;
  for (std::size_t i = 1; i < ranked.standings.size(); ++i) {
    const Standing& row = ranked.standings[i];
    if (row.separated_by.empty()) continue;
    text += fmt::format("{}{} below {} by {}", text.empty() ? "" : ", ", report.team(row.team),
                        report.team(ranked.standings[i - 1].team), row.separated_by);
  }
  return text.empty() ? text : text + ". ";
}

struct Heading {
  std::string text;
  Align align = Align::kLeft;
};

// Gives a table its title and columns, before its first row.
void begin(ReportTable& result, const char* title, const std::vector<Heading>& columns) {
  if (!result.empty()) return;
  result.title = title;
  for (const auto& [text, align] : columns) result.table.add_column(text, align);
}

std::string standings_note(const Report& report, const RankedTable& ranked) {
  const auto chosen = chosen_columns(report, ranked);
  const auto shows = [&chosen](std::string_view name) {
    return std::ranges::find(chosen, name, &StandingsColumn::name) != chosen.end();
  };

  std::string note = shows("tiebreaker") ? "" : tiebreaker_note(report, ranked);
  if (shows("score") || shows("interval")) {
    note += "Score %: of pairs (both sides of one seed) if there are any, else of single matches. ";
  }
  if (shows("shoot-outs")) note += "Shoot-outs won-lost count as won and lost, without goals. ";
  if (shows("forfeits")) note += "Forfeits won-lost count as won and lost, but not in score %. ";
  if (!note.empty()) note.pop_back();
  return note;
}

// End reason, cycles, seed, start, host and number of warnings.
void add_figures(const ScheduledMatch& match, std::vector<std::string>& cells) {
  const bool known = match.outcome.has_value();
  const Outcome outcome = match.outcome.value_or(Outcome());
  cells.emplace_back(known ? name(outcome.end_reason) : "not played");
  cells.push_back(known ? fmt::to_string(outcome.cycles) : "");
  cells.push_back(fmt::to_string(match.fixture.seed));
  cells.push_back(time_text(outcome.started));
  cells.push_back(outcome.host);
  cells.push_back(known ? fmt::to_string(outcome.warnings.size()) : "");
}

}  // namespace

std::string difference_text(double value, int decimals) {
  std::string text = fmt::format("{:+.{}f}", value, decimals);
  if (text.find_first_of("123456789") == std::string::npos) text.front() = '+';
  return text;
}

std::string headline(const Report& report) {
  const Competition& competition = report.config->competition;
  return fmt::format("{} of {} teams, seed {}: {}", name(competition.format),
                     competition.teams.size(), competition.seed, counts_text(report.counts));
}

std::vector<std::string> head_lines(const Report& report) {
  std::vector<std::string> lines;
  if (const TimeSpan span = time_span(report.matches); !span.first_start.empty()) {
    lines.push_back(fmt::format("Played from {} to {} UTC.", time_text(span.first_start),
                                time_text(span.last_end)));
  }

  std::string hosts;
  for (const HostFigures& host : report.hosts) {
    hosts += fmt::format("{}{} ({})", hosts.empty() ? "" : ", ", host.host,
                         base::counted(host.matches, "match", "matches"));
  }
  if (!hosts.empty()) {
    lines.push_back(fmt::format("{}: {}.", report.hosts.size() == 1 ? "Host" : "Hosts", hosts));
  }

  if (const auto known = versions(report.matches); !known.empty()) {
    lines.push_back(fmt::format("Versions: {}.", fmt::join(known, ", ")));
  }

  std::string byes;
  for (const Bye& bye : report.byes) {
    byes +=
        fmt::format("{}round {} {}", byes.empty() ? "" : ", ", bye.round, report.team(bye.team));
  }
  if (!byes.empty()) lines.push_back(fmt::format("Byes: {}.", byes));
  return lines;
}

std::string match_text(const Report& report, const ScheduledMatch& match) {
  return fmt::format("match {}, {} {} {}", match.fixture.index, report.team(match.fixture.left),
                     score_text(*report.config, match), report.team(match.fixture.right));
}

std::vector<std::string> warning_lines(const Report& report) {
  std::vector<std::string> lines;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome) continue;
    for (const std::string& warning : match.outcome->warnings) {
      lines.push_back(fmt::format("{}: {}", match_text(report, match), base::printable(warning)));
    }
  }
  return lines;
}

std::string rerun_lines(const Report& report) {
  std::string text;
  for (const ScheduledMatch& match : report.matches) {
    fmt::format_to(std::back_inserter(text), "# {}\n{}\n", match_text(report, match),
                   rerun_command(*report.config, match.fixture));
  }
  return text;
}

std::vector<RankedTable> tables_by_interest(const Report& report) {
  std::vector<RankedTable> tables = report.tables;
  const Format format = report.config->competition.format;
  const bool ends_with_final = format == Format::kStages || format == Format::kGroups;
  if (ends_with_final && report.complete && !tables.empty()) {
    std::rotate(tables.begin(), tables.end() - 1, tables.end());
  }
  return tables;
}

ReportTable standings_table(const Report& report, const RankedTable& ranked, Headings headings) {
  ReportTable result;
  result.title = ranked.title.empty() ? "standings" : ranked.title;
  result.note = standings_note(report, ranked);

  const auto columns = chosen_columns(report, ranked);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const StandingsColumn& column = *columns[i];
    result.table.add_column(headings == Headings::kShort ? column.short_heading : column.heading,
                            column.align);
    if (column.name == "team") result.key_columns = i + 1;  // those up to it identify a row
  }

  for (const Standing& row : ranked.standings) {
    std::vector<std::string> cells;
    for (const StandingsColumn* column : columns) cells.push_back(column->cell(report, row));
    result.table.add_row(std::move(cells));
  }
  return result;
}

ReportTable crosstable(const Report& report, bool numbered) {
  const auto& standings = report.tables.back().standings;
  const bool bracket_only = rules_of(report.config->competition).bracket_only;
  ReportTable result;
  if (bracket_only || standings.size() < 3 || standings.size() > 20) return result;

  result.title = "won-drawn-lost, row against column";
  const auto label = [&](std::size_t place) {
    const std::string& team = report.team(standings[place].team);
    return numbered ? fmt::format("{:>2} {}", place + 1, team) : team;
  };
  base::Table& table = result.table;
  table.add_column("team");
  for (std::size_t place = 0; place < standings.size(); ++place) {
    table.add_column(numbered ? fmt::to_string(place + 1) : label(place), Align::kRight);
  }

  bool forfeits = false;
  for (std::size_t row = 0; row < standings.size(); ++row) {
    std::vector<std::string> cells = {label(row)};
    for (const Standing& column : standings) {
      const auto head_to_head = find_head_to_head(report, standings[row].team, column.team);
      forfeits = forfeits || (head_to_head && head_to_head->forfeits.any());
      cells.push_back(head_to_head ? crosstable_cell(*head_to_head) : ".");
    }
    table.add_row(std::move(cells));
  }
  if (forfeits) result.note = "f+1: one win by forfeit, f-2: two losses by forfeit.";
  return result;
}

ReportTable head_to_head_table(const Report& report) {
  constexpr std::size_t kMaxRows = 40;
  std::vector<const HeadToHead*> rows;
  for (const HeadToHead& head_to_head : report.head_to_heads) {
    if (head_to_head.games.games() > 0) rows.push_back(&head_to_head);
  }

  ReportTable result;
  if (rows.empty() || rows.size() > kMaxRows) return result;
  result.title = "A against B";
  result.key_columns = 2;
  result.note =
      "Elo: of A against B, with its 95 % interval. Better: likelihood that A is the better team. "
      "All from pairs where there are any, else from single matches.";
  base::Table& table = result.table;
  table.add_columns({"A", "against B"});
  table.add_columns({"Elo of A", "95 %", "score %", "95 %", "better", "W-D-L", "goals"},
                    Align::kRight);
  table.add_column("from");

  for (const HeadToHead* row : rows) {
    const Estimate strength = row->strength();
    table.add_row({report.team(row->first), report.team(row->second), difference_text(strength.elo),
                   fmt::format("{}..{}", difference_text(strength.elo_interval.low),
                               difference_text(strength.elo_interval.high)),
                   percent(strength.score), interval(strength.score_interval),
                   superiority(strength.superiority), record_text(row->games), goals_text(*row),
                   sample_text(*row)});
  }
  return result;
}

std::vector<std::size_t> rated_teams(const Report& report) {
  std::vector<std::size_t> order;  // without teams that have only forfeits
  for (std::size_t team = 0; team < report.records.size(); ++team) {
    if (report.records[team].games.games() > 0) order.push_back(team);
  }
  const std::vector<double>& elo = report.ratings.elo;
  std::ranges::stable_sort(order, std::greater(), [&elo](std::size_t team) { return elo[team]; });
  return order;
}

ReportTable ratings_table(const Report& report) {
  ReportTable result;
  const std::vector<std::size_t> order = rated_teams(report);
  if (report.config->competition.teams.size() < 3 || order.empty()) return result;

  result.title = "rating";
  result.note =
      "Bradley-Terry over all matches; 0 is the mean of the teams. Better: likelihood that the "
      "team is better than the next one.";
  base::Table& table = result.table;
  table.add_column("team");
  table.add_columns({"Elo", "+- 95 %", "better", "matches"}, Align::kRight);

  const Ratings& ratings = report.ratings;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t team = order[i];
    table.add_row({report.team(static_cast<int>(team)), difference_text(ratings.elo[team]),
                   fmt::format("{:.0f}", ratings.error[team]),
                   i + 1 < order.size() ? superiority(ratings.superiority[team][order[i + 1]]) : "",
                   fmt::to_string(report.records[team].games.games())});
  }
  return result;
}

ReportTable playmakers_table(const Report& report, bool endpoints) {
  ReportTable result;
  const auto& all = report.playmakers;
  const bool played = std::ranges::any_of(
      all, [](const PlaymakerFigures& figures) { return figures.decisions > 0; });
  if (!played && !endpoints) return result;

  result.title = "Playmakers";
  result.note =
      "Latencies of replies in ms: p50 of the median player in the median match; p95, p99 and "
      "maximum of the slowest player in the slowest match. Missed decisions include late ones.";
  base::Table& table = result.table;
  table.add_column("team");
  table.add_columns({"decisions", "p50 ms", "p95 ms", "p99 ms", "max ms", "late", "missed"},
                    Align::kRight);
  if (endpoints) table.add_column("endpoint");

  for (std::size_t i = 0; i < all.size(); ++i) {
    const TeamEntry& team = report.config->competition.teams[i];
    const PlaymakerFigures& one = all[i];
    std::vector<std::string> cells = {team.name,
                                      fmt::to_string(one.decisions),
                                      milliseconds(one.p50_us),
                                      milliseconds(one.p95_us),
                                      milliseconds(one.p99_us),
                                      milliseconds(one.max_us),
                                      fmt::to_string(one.late),
                                      fmt::to_string(one.missed)};
    if (one.decisions == 0) std::fill(cells.begin() + 1, cells.end(), "-");
    if (endpoints) cells.push_back(team.endpoint);
    table.add_row(std::move(cells));
  }
  return result;
}

ReportTable hosts_table(const Report& report) {
  ReportTable result;
  if (report.hosts.size() < 2) return result;
  result.title = "hosts";
  base::Table& table = result.table;
  table.add_column("host");
  table.add_columns({"matches", "cycles/s", "missed", "missed %"}, Align::kRight);
  table.add_column("");

  for (const HostFigures& host : report.hosts) {
    table.add_row({host.host, fmt::to_string(host.matches),
                   fmt::format("{:.0f}", host.cycles_per_second), fmt::to_string(host.missed),
                   fmt::format("{:.3f}", 100 * host.missed_share()),
                   host.outlier ? "OUTLIER" : ""});
    if (host.outlier) {
      result.note =
          "OUTLIER: misses more than twice as many decisions as the other hosts, by more than "
          "three standard errors. It may be overloaded.";
    }
  }
  return result;
}

ReportTable decisions_table(const Report& report) {
  ReportTable result;
  for (const ScheduledMatch& match : report.matches) {
    for (std::size_t i = 0; i < match.history.size(); ++i) {
      begin(result, "decisions",
            {{"match", Align::kRight},
             {"stage"},
             {"left"},
             {"right"},
             {"was"},
             {"decision"},
             {"reason"},
             {"UTC"},
             {"logs of what was"}});

      const MatchDecision& decision = match.history[i];
      if (is_about_teams(decision.kind)) {
        result.table.add_row(
            {"-", decision.table.empty() ? "-" : decision.table, "-", "-", "-",
             decision_text(match, i) + ": " + team_list(report.config->competition, decision.teams),
             base::printable(decision.reason), time_text(decision.time), "-"});
        continue;
      }
      result.table.add_row({fmt::to_string(match.fixture.index), stage_text(match.fixture),
                            report.team(match.fixture.left), report.team(match.fixture.right),
                            decision.before.empty() ? "-" : decision.before,
                            decision_text(match, i), base::printable(decision.reason),
                            time_text(decision.time),
                            decision.folder.empty() ? "-" : decision.folder});
    }
  }
  return result;
}

ReportTable pauses_table(const Report& report) {
  ReportTable result;
  for (const Pause& pause : report.pauses) {
    begin(result, "technical time-outs", {{"from UTC"}, {"to UTC"}, {"reason"}});
    result.table.add_row({time_text(pause.begin), pause.end.empty() ? "-" : time_text(pause.end),
                          base::printable(pause.reason)});
  }
  return result;
}

ReportTable schedule_table(const Report& report) {
  constexpr std::size_t kListed = 40;
  ReportTable result;
  const std::span<const PlannedStart> starts = report.timetable.starts;
  for (const PlannedStart& start : starts.first(std::min(starts.size(), kListed))) {
    begin(result, "next matches",
          {{"match", Align::kRight}, {"start"}, {"server"}, {"stage"}, {"left"}, {"right"}});
    const Fixture& fixture = report.matches[base::index(start.match) - 1].fixture;
    result.table.add_row({fmt::to_string(start.match), local_time_text(start.time),
                          fmt::to_string(start.server), stage_text(fixture),
                          report.team(fixture.left), report.team(fixture.right)});
  }
  return result;
}

ReportTable failures_table(const Report& report) {
  ReportTable result;
  for (const ScheduledMatch& match : report.matches) {
    if (!failed(match)) continue;
    begin(result, "failed matches",
          {{"match", Align::kRight}, {"left"}, {"right"}, {"end reason"}, {"message"}, {"logs"}});
    const Outcome& outcome = *match.outcome;
    result.table.add_row({fmt::to_string(match.fixture.index), report.team(match.fixture.left),
                          report.team(match.fixture.right), std::string(name(outcome.end_reason)),
                          outcome.message, outcome.folder.empty() ? "" : "logs"});
    link_folder(report, match, "", 5, result.table);
  }
  return result;
}

ReportTable matches_table(const Report& report, MatchDetails details) {
  constexpr std::size_t kLinkColumn = 5;
  ReportTable result;
  if (report.matches.empty()) return result;

  const bool links = details == MatchDetails::kLinks;
  const bool figures = links || details == MatchDetails::kFigures;
  const bool replays = links && !report.replays.empty();
  begin(result, "matches",
        {{"match", Align::kRight}, {"stage"}, {"left"}, {"score", Align::kRight}, {"right"}});
  base::Table& table = result.table;
  if (links) table.add_column("logs");
  if (replays) table.add_column("replay");
  if (figures) {
    table.add_column("end reason");
    table.add_columns({"cycles", "seed"}, Align::kRight);
    table.add_columns({"started (UTC)", "host"});
    table.add_column("warnings", Align::kRight);
  }

  for (const ScheduledMatch& match : report.matches) {
    const Fixture& fixture = match.fixture;
    std::vector<std::string> cells = {fmt::to_string(fixture.index), stage_text(fixture),
                                      report.team(fixture.left), score_text(*report.config, match),
                                      report.team(fixture.right)};
    if (links) cells.emplace_back(match.outcome && !match.outcome->folder.empty() ? "logs" : "");
    const bool replay = replays && report.replays.contains(fixture.index);
    if (replays) cells.emplace_back(replay ? "watch" : "");
    if (figures) add_figures(match, cells);

    table.add_row(std::move(cells));
    if (links) link_folder(report, match, "", kLinkColumn, table);
    if (replay) link_folder(report, match, kReplayPage, kLinkColumn + 1, table);
  }
  return result;
}

}  // namespace cls::tournament
