// Reports as JSON (cls.tournament/1), CSV and JUnit.
#include "tournament/report/report_document.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/report/junit.h"
#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/table.h"
#include "league/rating/statistics.h"
#include "tournament/config/start_times.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

using base::Json;

double tenths(double value) { return std::round(value * 10) / 10; }

void add_strength(Json& json, const Estimate& strength) {
  json["score_rate"] = rounded(strength.score);
  json["score_interval"] = {rounded(strength.score_interval.low),
                            rounded(strength.score_interval.high)};
}

Json json_of(const WinLoss& record) { return {{"won", record.won}, {"lost", record.lost}}; }

Json json_of(const Report& report, const Standing& standing) {
  const std::size_t team = base::index(standing.team);
  Json json = {{"rank", standing.rank},
               {"team", report.team(standing.team)},
               {"played", standing.played},
               {"won", standing.won},
               {"drawn", standing.drawn},
               {"lost", standing.lost},
               {"invalid", standing.invalid},
               {"goals_for", standing.goals_for},
               {"goals_against", standing.goals_against},
               {"goal_difference", standing.goal_difference()},
               {"points", standing.points},
               {"shoot_outs", json_of(standing.shoot_outs)},
               {"forfeits", json_of(standing.forfeits)}};

  add_strength(json, standing.record.strength());
  json["elo"] = tenths(report.ratings.elo[team]);
  json["elo_error"] = tenths(report.ratings.error[team]);

  if (rules_of(report.config->competition).shows_opponents) {
    json["byes"] = standing.byes;
    json["buchholz"] = standing.buchholz;
    json["median_buchholz"] = standing.median_buchholz;
    json["sonneborn_berger"] = standing.sonneborn_berger;
  }

  json["separated_by"] =
      standing.separated_by.empty() ? Json(nullptr) : Json(standing.separated_by);
  return json;
}

Json json_of(const Report& report, const std::vector<Standing>& table) {
  Json rows = Json::array();
  for (const Standing& standing : table) rows.push_back(json_of(report, standing));
  return rows;
}

Json json_of(const Report& report, const HeadToHead& head_to_head) {
  const Estimate strength = head_to_head.strength();
  Json json = {{"team", report.team(head_to_head.first)},
               {"opponent", report.team(head_to_head.second)},
               {"won", head_to_head.games.won},
               {"drawn", head_to_head.games.drawn},
               {"lost", head_to_head.games.lost},
               {"goals_for", head_to_head.goals_for},
               {"goals_against", head_to_head.goals_against},
               {"shoot_outs", json_of(head_to_head.shoot_outs)},
               {"forfeits", json_of(head_to_head.forfeits)},
               {"pairs", head_to_head.pairs},
               {"single_games", head_to_head.single_games},
               {"model", head_to_head.paired() ? "pairs" : "games"}};

  add_strength(json, strength);
  json["elo"] = tenths(strength.elo);
  json["elo_interval"] = {tenths(strength.elo_interval.low), tenths(strength.elo_interval.high)};
  json["superiority"] = rounded(strength.superiority);
  return json;
}

Json teams_json(const Report& report) {
  Json teams = Json::array();
  for (std::size_t i = 0; i < report.playmakers.size(); ++i) {
    const TeamEntry& team = report.config->competition.teams[i];
    const PlaymakerFigures& figures = report.playmakers[i];
    teams.push_back({{"name", team.name},
                     {"endpoint", team.endpoint},
                     {"decisions", figures.decisions},
                     {"late", figures.late},
                     {"missed", figures.missed},
                     {"rpc_us",
                      {{"p50", tenths(figures.p50_us)},
                       {"p95", tenths(figures.p95_us)},
                       {"p99", tenths(figures.p99_us)},
                       {"max", tenths(figures.max_us)}}}});
  }
  return teams;
}

Json hosts_json(const Report& report) {
  Json hosts = Json::array();
  for (const HostFigures& host : report.hosts) {
    hosts.push_back({{"host", host.host},
                     {"matches", host.matches},
                     {"decisions", host.decisions},
                     {"missed", host.missed},
                     {"cycles_per_second", tenths(host.cycles_per_second)},
                     {"outlier", host.outlier}});
  }
  return hosts;
}

Json json_of(const Report& report, const Entrant& entrant) {
  Json json = {{"team", entrant.team ? Json(report.team(*entrant.team)) : Json(nullptr)},
               {"bye", entrant.bye},
               {"from", nullptr}};
  if (entrant.tie >= 0) {
    json["from"] = {{"stage", report.bracket[base::index(entrant.tie)].stage},
                    {"winner", entrant.winner}};
  }
  return json;
}

Json bracket_json(const Report& report) {
  Json ties = Json::array();
  for (const BracketTie& tie : report.bracket) {
    Json matches = Json::array();
    for (const ScheduledMatch& match : report.matches) {
      if (match.fixture.stage == tie.stage) matches.push_back(match.fixture.index);
    }
    ties.push_back(
        {{"round", tie.round},
         {"stage", tie.stage},
         {"entrants", {json_of(report, tie.entrants[0]), json_of(report, tie.entrants[1])}},
         {"winner", tie.winner ? Json(report.team(*tie.winner)) : Json(nullptr)},
         {"by_lot", tie.by_lot},
         {"matches", std::move(matches)}});
  }
  return ties;
}

Json byes_json(const Report& report) {
  Json byes = Json::array();
  for (const Bye& bye : report.byes) {
    byes.push_back({{"round", bye.round}, {"team", report.team(bye.team)}});
  }
  return byes;
}

Json stages_json(const TournamentConfig& config) {
  Json stages = Json::array();
  for (const Stage& stage : config.competition.stages) {
    stages.push_back({{"name", stage.name}, {"format", name(stage.format)}, {"legs", stage.legs}});
  }
  return stages;
}

// ISO 8601; null while no match was played.
Json time_json(const std::string& time) { return time.empty() ? Json(nullptr) : Json(time); }

using base::csv_cell;

std::string number_or_empty(const std::optional<int>& number) {
  return number ? fmt::to_string(*number) : "";
}

struct FixtureColumn {
  std::string_view name;
  std::string (*cell)(const Report&, const Fixture&);
};
constexpr std::array<FixtureColumn, 7> kFixtureColumns = {{
    {"index", [](const Report&, const Fixture& f) { return fmt::to_string(f.index); }},
    {"round", [](const Report&, const Fixture& f) { return fmt::to_string(f.round); }},
    {"stage", [](const Report&, const Fixture& f) { return f.stage; }},
    {"pairing", [](const Report&, const Fixture& f) { return fmt::to_string(f.pairing); }},
    {"left", [](const Report& report, const Fixture& f) { return report.team(f.left); }},
    {"right", [](const Report& report, const Fixture& f) { return report.team(f.right); }},
    {"seed", [](const Report&, const Fixture& f) { return fmt::to_string(f.seed); }},
}};

struct OutcomeColumn {
  std::string_view name;
  std::string (*cell)(const Outcome&);
};
constexpr std::array<OutcomeColumn, 20> kOutcomeColumns = {{
    {"end_reason", [](const Outcome& o) { return std::string(name(o.end_reason)); }},
    {"forfeit", [](const Outcome& o) { return std::string(o.forfeit ? "1" : "0"); }},
    {"left_score", [](const Outcome& o) { return fmt::to_string(o.left_score); }},
    {"right_score", [](const Outcome& o) { return fmt::to_string(o.right_score); }},
    {"left_penalties", [](const Outcome& o) { return number_or_empty(o.left_penalties); }},
    {"right_penalties", [](const Outcome& o) { return number_or_empty(o.right_penalties); }},
    {"cycles", [](const Outcome& o) { return fmt::to_string(o.cycles); }},
    {"wall_seconds", [](const Outcome& o) { return fmt::format("{:.3f}", o.wall_seconds); }},
    {"cycles_per_second",
     [](const Outcome& o) { return fmt::format("{:.1f}", o.cycles_per_second); }},
    {"left_missed", [](const Outcome& o) { return fmt::to_string(o.left.missed); }},
    {"right_missed", [](const Outcome& o) { return fmt::to_string(o.right.missed); }},
    {"attempts", [](const Outcome& o) { return fmt::to_string(o.attempts); }},
    {"host", [](const Outcome& o) { return o.host; }},
    {"started", [](const Outcome& o) { return o.started; }},
    {"ended", [](const Outcome& o) { return o.ended; }},
    {"folder", [](const Outcome& o) { return o.folder; }},
    {"message", [](const Outcome& o) { return o.message; }},
    {"version", [](const Outcome& o) { return o.version; }},
    {"server", [](const Outcome& o) { return o.server; }},
    {"warnings", [](const Outcome& o) { return fmt::to_string(o.warnings.size()); }},
}};

base::JunitCase junit_case(const Report& report, const ScheduledMatch& match) {
  const Fixture& fixture = match.fixture;
  base::JunitCase one;
  one.group = fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage;
  one.name = fmt::format("{} {} - {}", fixture.index, report.team(fixture.left),
                         report.team(fixture.right));

  if (!match.outcome) {
    one.result = base::JunitCase::Result::kSkipped;
    one.message = "not played";
    return one;
  }

  const Outcome& outcome = *match.outcome;
  one.seconds = outcome.wall_seconds;
  if (!failed(match)) {
    one.text = score_text(*report.config, match);
    return one;
  }

  one.result = outcome.fault ? base::JunitCase::Result::kFailed : base::JunitCase::Result::kError;
  one.type = name(outcome.end_reason);
  one.message = outcome.message;
  one.text = "rerun: " + rerun_command(*report.config, fixture);
  return one;
}

Json pauses_json(const Report& report) {
  Json pauses = Json::array();
  for (const Pause& pause : report.pauses) {
    pauses.push_back({{"begin", pause.begin},
                      {"end", pause.end.empty() ? Json(nullptr) : Json(pause.end)},
                      {"reason", pause.reason}});
  }
  return pauses;
}

Json superiority_json(const Report& report) {
  Json rows = Json::array();
  for (const auto& row : report.ratings.superiority) {
    rows.push_back(Json::array());
    for (const double one : row) rows.back().push_back(rounded(one));
  }
  return rows;
}

}  // namespace

base::Json json_of(const Timetable& timetable) {
  Json starts = Json::array();
  for (const PlannedStart& start : timetable.starts) {
    starts.push_back(
        {{"match", start.match}, {"start", utc_time_text(start.time)}, {"server", start.server}});
  }
  return starts;
}

std::string report_json(const Report& report) {
  const TournamentConfig& config = *report.config;
  Json matches = Json::array();
  for (const ScheduledMatch& match : report.matches) {
    matches.push_back(json_of(config, match));
    matches.back()["command"] = rerun_command(config, match.fixture);
  }

  Json all_tables = Json::array();
  for (const RankedTable& table : report.tables) {
    all_tables.push_back({{"title", table.title}, {"standings", json_of(report, table.standings)}});
  }

  Json crosstable = Json::array();
  for (const HeadToHead& head_to_head : report.head_to_heads)
    crosstable.push_back(json_of(report, head_to_head));

  Json breakers = Json::array();
  for (const TieBreaker breaker : tie_breakers_of(config.competition))
    breakers.push_back(name(breaker));

  const TimeSpan span = time_span(report.matches);
  const Json document = {
      {"schema", "cls.tournament/1"},
      {"name", report.name},
      {"started", time_json(span.first_start)},
      {"ended", time_json(span.last_end)},
      {"format", name(config.competition.format)},
      {"rounds", rounds_of(config.competition)},
      {"seed", config.competition.seed},
      {"swap_sides", config.competition.swap_sides},
      {"stages", stages_json(config)},
      {"tie_breakers", std::move(breakers)},
      {"teams", teams_json(report)},
      {"hosts", hosts_json(report)},
      {"complete", report.complete},
      {"counts",
       {{"scheduled", report.counts.scheduled},
        {"finished", report.counts.finished},
        {"forfeits", report.counts.forfeits},
        {"invalid", report.counts.invalid},
        {"annulled", report.counts.annulled},
        {"open", report.counts.open}}},
      {"standings", json_of(report, report.tables.back().standings)},
      {"tables", std::move(all_tables)},
      {"crosstable", std::move(crosstable)},
      {"bracket", bracket_json(report)},
      {"byes", byes_json(report)},
      {"schedule", json_of(report.timetable)},
      {"pauses", pauses_json(report)},
      {"rating", {{"model", "Bradley-Terry"}, {"superiority", superiority_json(report)}}},
      {"matches", std::move(matches)},
      {"versions", {{"cls", base::kVersion}, {"wire", base::kWireVersion}}}};
  return base::json_document(document);
}

std::string report_csv(const Report& report) {
  std::vector<std::string> cells;
  for (const FixtureColumn& column : kFixtureColumns) cells.emplace_back(column.name);
  for (const OutcomeColumn& column : kOutcomeColumns) cells.emplace_back(column.name);
  cells.emplace_back("command");

  std::string text = fmt::format("{}\n", fmt::join(cells, ","));
  for (const ScheduledMatch& match : report.matches) {
    cells.clear();
    for (const FixtureColumn& column : kFixtureColumns) {
      cells.push_back(csv_cell(column.cell(report, match.fixture)));
    }
    for (const OutcomeColumn& column : kOutcomeColumns) {
      cells.push_back(match.outcome ? csv_cell(column.cell(*match.outcome)) : "");
    }
    cells.push_back(csv_cell(rerun_command(*report.config, match.fixture)));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
}

std::string report_junit(const Report& report) {
  std::vector<base::JunitCase> cases;
  for (const ScheduledMatch& match : report.matches) cases.push_back(junit_case(report, match));
  return base::format_junit("cls tournament", cases);
}

}  // namespace cls::tournament
