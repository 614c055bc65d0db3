// The JSON report.
#include "orchestration/tournament/report/report_document.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/system/version.h"
#include "orchestration/tournament/store/match_document.h"

namespace cls::orchestration::tournament {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }
double tenths(double value) { return std::round(value * 10) / 10; }

void add_strength(Json& json, const Estimate& strength) {
  json["score_rate"] = rounded(strength.score);
  json["score_interval"] = {rounded(strength.score_interval.low),
                            rounded(strength.score_interval.high)};
}

Json json_of(const Report& report, const Standing& standing) {
  const auto team = static_cast<std::size_t>(standing.team);
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
               {"points", standing.points}};
  add_strength(json, strength_of(report.records[team]));
  json["elo"] = tenths(report.ratings.elo[team]);
  json["elo_error"] = tenths(report.ratings.error[team]);
  if (report.config->format == Format::kSwiss) {
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

Json json_of(const Report& report, const Duel& duel) {
  const Estimate strength = duel.strength();
  Json json = {{"team", report.team(duel.first)},
               {"opponent", report.team(duel.second)},
               {"won", duel.games.won},
               {"drawn", duel.games.drawn},
               {"lost", duel.games.lost},
               {"goals_for", duel.goals_for},
               {"goals_against", duel.goals_against},
               {"pairs", duel.pairs},
               {"single_games", duel.single_games},
               {"model", duel.paired() ? "pairs" : "games"}};
  add_strength(json, strength);
  json["elo"] = tenths(strength.elo);
  json["elo_interval"] = {tenths(strength.elo_interval.low), tenths(strength.elo_interval.high)};
  json["superiority"] = rounded(strength.superiority);
  return json;
}

Json teams_json(const TournamentConfig& config) {
  Json teams = Json::array();
  for (const TeamEntry& team : config.teams) {
    teams.push_back({{"name", team.name}, {"endpoint", team.endpoint}});
  }
  return teams;
}

}  // namespace

std::string report_json(const Report& report) {
  const TournamentConfig& config = *report.config;
  Json matches = Json::array();
  for (const ScheduledMatch& match : report.matches) {
    matches.push_back(json_of(config, match));
    matches.back()["command"] = rerun_line(config, match.fixture);
  }
  Json all_tables = Json::array();
  for (const RankedTable& table : report.tables) {
    all_tables.push_back({{"title", table.title}, {"standings", json_of(report, table.standings)}});
  }
  Json crosstable = Json::array();
  for (const Duel& duel : report.duels) crosstable.push_back(json_of(report, duel));
  Json superiority = Json::array();
  for (const auto& row : report.ratings.superiority) {
    superiority.push_back(Json::array());
    for (const double one : row) superiority.back().push_back(rounded(one));
  }
  Json breakers = Json::array();
  for (const TieBreaker breaker : tie_breakers_of(config)) breakers.push_back(name(breaker));
  const Json document = {
      {"schema", "cls.tournament/1"},
      {"format", name(config.format)},
      {"rounds", rounds_of(config)},
      {"seed", config.seed},
      {"swap_sides", config.swap_sides},
      {"tie_breakers", std::move(breakers)},
      {"teams", teams_json(config)},
      {"complete", report.complete},
      {"counts",
       {{"scheduled", report.counts.scheduled},
        {"finished", report.counts.finished},
        {"forfeits", report.counts.forfeits},
        {"invalid", report.counts.invalid},
        {"open", report.counts.open}}},
      {"standings", json_of(report, report.tables.back().standings)},
      {"tables", std::move(all_tables)},
      {"crosstable", std::move(crosstable)},
      {"rating", {{"model", "Bradley-Terry"}, {"superiority", std::move(superiority)}}},
      {"matches", std::move(matches)},
      {"versions", {{"cls", base::kVersion}, {"wire", base::kWireVersion}}}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cls::orchestration::tournament
