// Formats the JSON document of results.
#include "analysis/results/results_text.h"
#include "base/text/json.h"

#include "analysis/results/team_table.h"
#include "base/text/json_text.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

using base::Json;

Json event_json(const PlayerEvent& event) {
  return {{"cycle", event.cycle}, {"side", side_name(event.side)}, {"unum", event.unum}};
}

template <typename Event, typename Convert>
Json list_json(const std::vector<Event>& events, Convert convert) {
  Json list = Json::array();
  for (const Event& event : events) list.push_back(convert(event));
  return list;
}

Json goal_json(const GoalSummary& goal) {
  Json json = event_json({goal.cycle, goal.side, goal.unum});
  if (goal.unum == 0) json["unum"] = nullptr;
  json["own_goal"] = goal.own_goal;
  return json;
}

Json card_json(const CardSummary& card) {
  Json json = event_json(card);
  json["card"] = card.red ? "red" : "yellow";
  return json;
}

Json substitution_json(const SubstitutionSummary& change) {
  Json json = event_json(change);
  json["from_type"] = change.from_type;
  json["to_type"] = change.to_type;
  return json;
}

Json team_json(const MatchSummary& match, std::size_t index) {
  const TeamSummary& team = match.teams[index];
  Json json;
  json["name"] = team.name.empty() ? Json(nullptr) : Json(team.name);
  json["score"] = team.score;
  json["first_half"] = team.first_half;
  json["penalty_score"] = match.penalties ? Json(team.penalty_score) : Json(nullptr);
  json["penalty_missed"] = match.penalties ? Json(team.penalty_missed) : Json(nullptr);
  return json;
}

Json match_json(const MatchSummary& match) {
  const std::string_view winner = winner_name(match.winner);
  Json json;
  json["file"] = match.file;
  if (!match.text_log.empty()) json["text_log"] = match.text_log;
  json["version"] = match.version;
  json["date"] = match.date.empty() ? Json(nullptr) : Json(match.date);
  json["left"] = team_json(match, 0);
  json["right"] = team_json(match, 1);
  json["winner"] = winner.empty() ? Json(nullptr) : Json(winner);
  json["coin_toss"] = match.coin_toss;
  json["cycles"] = match.cycles;
  json["frames"] = match.frames;
  json["complete"] = match.complete;
  json["end_reason"] = match.end_reason.empty() ? Json(nullptr) : Json(match.end_reason);

  json["goals"] = list_json(match.goals, goal_json);
  json["cards"] = list_json(match.cards, card_json);
  json["substitutions"] = list_json(match.substitutions, substitution_json);
  json["disconnections"] = list_json(match.disconnections, event_json);
  json["reconnections"] = list_json(match.reconnections, event_json);
  json["late_starts"] = list_json(match.late_starts, event_json);
  json["never_connected"] = list_json(match.never_connected, [](const PlayerEvent& event) {
    return Json{{"side", side_name(event.side)}, {"unum", event.unum}};
  });
  json["damage"] = match.parse_errors;
  return json;
}

Json standings_json(const TeamTable& standings) {
  return list_json(standings.rows, [](const TeamResults& row) {
    return Json{{"team", row.team},
                {"played", row.played},
                {"won", row.won},
                {"drawn", row.drawn},
                {"lost", row.lost},
                {"goals_for", row.goals_for},
                {"goals_against", row.goals_against},
                {"points", row.points}};
  });
}

}  // namespace

std::string results_json(const std::vector<MatchSummary>& matches) {
  const TeamTable standings = team_table(matches);
  Json json;
  json["schema"] = "cls.results/1";
  json["matches"] = list_json(matches, match_json);
  json["standings"] = standings_json(standings);
  json["not_counted"] = standings.not_counted;
  return base::json_document(json);
}

}  // namespace cls::analysis
