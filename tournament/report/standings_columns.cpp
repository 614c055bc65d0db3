// One row per column of the standings table.
#include "tournament/report/standings_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tournament/report/report_tables.h"

namespace cls::tournament {
namespace {

constexpr auto kLeft = base::Table::Align::kLeft;
constexpr auto kRight = base::Table::Align::kRight;

std::string score_cell(const Report& /*report*/, const Standing& row) {
  const Estimate known = row.record.strength();
  return known.count == 0 ? "-" : fmt::format("{:.1f}", 100 * known.score);
}

std::string interval_cell(const Report& /*report*/, const Standing& row) {
  const Estimate known = row.record.strength();
  if (known.count == 0) return "-";
  return fmt::format("{:.1f}..{:.1f}", 100 * known.score_interval.low,
                     100 * known.score_interval.high);
}

std::string average_cell(const Report& /*report*/, const Standing& row) {
  if (row.played == 0) return "-";
  return fmt::format("{:.2f}", static_cast<double>(row.points) / row.played);
}

std::string won_lost(const WinLoss& record) {
  return fmt::format("{}-{}", record.won, record.lost);
}

std::string elo_cell(const Report& report, const Standing& row) {
  return difference_text(report.ratings.elo[base::index(row.team)]);
}

std::string elo_error_cell(const Report& report, const Standing& row) {
  return fmt::format("{:.0f}", report.ratings.error[base::index(row.team)]);
}

template <int Standing::*member>
std::string count_cell(const Report& /*report*/, const Standing& row) {
  return fmt::to_string(row.*member);
}

template <double Standing::*member>
std::string number_cell(const Report& /*report*/, const Standing& row) {
  return fmt::format("{}", row.*member);
}

template <WinLoss Standing::*member>
std::string won_lost_cell(const Report& /*report*/, const Standing& row) {
  return won_lost(row.*member);
}

constexpr std::array<StandingsColumn, kStandingsColumns.size()> kColumns = {{
    {"rank", "#", "#", kRight, count_cell<&Standing::rank>},
    {"team", "team", "team", kLeft,
     [](const Report& report, const Standing& row) { return report.team(row.team); }},
    {"played", "played", "P", kRight, count_cell<&Standing::played>},
    {"won", "won", "W", kRight, count_cell<&Standing::won>},
    {"drawn", "drawn", "D", kRight, count_cell<&Standing::drawn>},
    {"lost", "lost", "L", kRight, count_cell<&Standing::lost>},
    {"goals", "goals", "goals", kRight,
     [](const Report&, const Standing& row) {
       return fmt::format("{}:{}", row.goals_for, row.goals_against);
     }},
    {"diff", "diff", "diff", kRight,
     [](const Report&, const Standing& row) { return fmt::format("{:+}", row.goal_difference()); }},
    {"points", "points", "pts", kRight, count_cell<&Standing::points>},
    {"score", "score %", "%", kRight, score_cell},
    {"interval", "95 %", "95 %", kRight, interval_cell},
    {"shoot-outs", "shoot-outs", "pen", kRight, won_lost_cell<&Standing::shoot_outs>},
    {"forfeits", "forfeits", "forf", kRight, won_lost_cell<&Standing::forfeits>},
    {"invalid", "invalid", "inv", kRight, count_cell<&Standing::invalid>},
    {"byes", "byes", "byes", kRight, count_cell<&Standing::byes>},
    {"buchholz", "buchholz", "buch", kRight, number_cell<&Standing::buchholz>},
    {"median-buchholz", "median buchholz", "med", kRight, number_cell<&Standing::median_buchholz>},
    {"sonneborn-berger", "sonneborn-berger", "s-b", kRight,
     number_cell<&Standing::sonneborn_berger>},
    {"tiebreaker", "tiebreaker", "by", kLeft,
     [](const Report&, const Standing& row) { return row.separated_by; }},
    {"elo", "Elo", "Elo", kRight, elo_cell},
    {"elo-error", "+- 95 %", "+-", kRight, elo_error_cell},
    {"average", "average", "avg", kRight, average_cell},
}};

const StandingsColumn& column(std::string_view name) {
  return *std::ranges::find(kColumns, name, &StandingsColumn::name);
}

template <typename Test>
bool any_row(const RankedTable& ranked, Test test) {
  return std::ranges::any_of(ranked.standings, test);
}

}  // namespace

std::vector<const StandingsColumn*> chosen_columns(const Report& report,
                                                   const RankedTable& ranked) {
  std::vector<const StandingsColumn*> chosen;
  for (const std::string& name : report.config->report.columns) chosen.push_back(&column(name));
  if (!chosen.empty()) return chosen;

  for (const char* name : {"rank", "team", "played", "won", "drawn", "lost", "goals", "diff",
                           "points", "score", "interval"}) {
    chosen.push_back(&column(name));
  }

  const auto add_if = [&chosen](bool wanted, const char* name) {
    if (wanted) chosen.push_back(&column(name));
  };
  add_if(ranked.average, "average");
  add_if(any_row(ranked, [](const Standing& row) { return row.shoot_outs.any(); }), "shoot-outs");
  add_if(any_row(ranked, [](const Standing& row) { return row.forfeits.any(); }), "forfeits");
  add_if(any_row(ranked, [](const Standing& row) { return row.invalid > 0; }), "invalid");
  add_if(rules_of(report.config->competition).shows_opponents, "buchholz");
  return chosen;
}

}  // namespace cls::tournament
