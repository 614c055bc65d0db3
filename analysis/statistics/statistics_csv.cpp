// CSV tables of teams, players and events.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/fields.h"
#include "analysis/statistics/statistics_text.h"

namespace cls::analysis {
namespace {

/// A column, and the JSON pointer of its value in a row. Missing values give empty cells.
struct Column {
  const char* name;
  const char* value;
};

const std::vector<Column> kTeamColumns = {
    {"file", "/file"},
    {"side", "/side"},
    {"name", "/team/name"},
    {"score", "/team/score"},
    {"opponent", "/opponent/name"},
    {"opponent_score", "/opponent/score"},
    {"cycles", "/cycles"},
    {"complete", "/complete"},
    {"possession", "/team/possession/last_touch"},
    {"possession_at_feet", "/team/possession/at_feet"},
    {"possession_fastest", "/team/possession/fastest"},
    {"touches", "/team/touches"},
    {"passes", "/team/passes/attempted"},
    {"completed", "/team/passes/completed"},
    {"mean_pass", "/team/passes/mean_length"},
    {"through", "/team/passes/through"},
    {"crosses", "/team/passes/crosses"},
    {"one_twos", "/team/passes/one_twos"},
    {"dribbles", "/team/dribbles"},
    {"take_ons", "/team/take_ons"},
    {"shots", "/team/shots/total"},
    {"on_target", "/team/shots/on_target"},
    {"goals", "/goals"},
    {"expected_goals", "/team/shots/expected_goals"},
    {"tackles", "/team/tackles/tried"},
    {"tackles_hit", "/team/tackles/succeeded"},
    {"tackles_effective", "/team/tackles/effective"},
    {"interceptions", "/team/interceptions"},
    {"recoveries", "/team/pressing/recoveries"},
    {"box_entries", "/team/territory/box_entries"},
    {"box_touches", "/team/territory/box_touches"},
    {"final_third_touches", "/team/territory/final_third_touches"},
    {"pitch_control", "/team/territory/pitch_control"},
    {"corners", "/team/stoppages/corners"},
    {"kick_ins", "/team/stoppages/kick_ins"},
    {"goal_kicks", "/team/stoppages/goal_kicks"},
    {"free_kicks", "/team/stoppages/free_kicks"},
    {"indirect_free_kicks", "/team/stoppages/indirect_free_kicks"},
    {"catches", "/team/goalkeeping/catches"},
    {"saves", "/team/goalkeeping/saves"},
    {"offsides", "/team/stoppages/offsides"},
    {"fouls", "/team/stoppages/fouls"},
    {"yellow", "/team/stoppages/yellow_cards"},
    {"red", "/team/stoppages/red_cards"},
    {"distance", "/team/distance"},
    {"stamina_used", "/team/stamina_used"},
    {"exhausted_frames", "/team/exhausted_frames"},
    {"silent_steps", "/team/silent_steps"},
    {"rejected_commands", "/team/rejected_commands"},
};

const std::vector<Column> kPlayerColumns = {
    {"file", "/file"},
    {"side", "/player/side"},
    {"name", "/name"},
    {"unum", "/player/unum"},
    {"frames", "/player/frames"},
    {"touches", "/player/ball/touches"},
    {"passes", "/player/ball/passes"},
    {"completed", "/player/ball/completed"},
    {"received", "/player/ball/received"},
    {"key_passes", "/player/ball/key_passes"},
    {"assists", "/player/ball/assists"},
    {"dribbles", "/player/ball/dribbles"},
    {"take_ons", "/player/ball/take_ons"},
    {"shots", "/player/ball/shots"},
    {"on_target", "/player/ball/on_target"},
    {"goals", "/player/ball/goals"},
    {"own_goals", "/player/ball/own_goals"},
    {"expected_goals", "/player/ball/expected_goals"},
    {"threat_added", "/player/ball/threat_added"},
    {"tackles", "/player/tackles/tried"},
    {"tackles_hit", "/player/tackles/succeeded"},
    {"interceptions", "/player/interceptions"},
    {"recoveries", "/player/recoveries"},
    {"losses", "/player/ball/losses"},
    {"fouls", "/player/fouls"},
    {"fouled", "/player/fouled"},
    {"yellow", "/player/yellow_cards"},
    {"red", "/player/red_cards"},
    {"distance", "/player/movement/distance"},
    {"top_speed", "/player/movement/top_speed"},
    {"stamina_used", "/player/stamina/used"},
    {"lowest_stamina", "/player/stamina/lowest"},
    {"exhausted_frames", "/player/stamina/exhausted_frames"},
    {"mean_x", "/player/position/mean/0"},
    {"mean_y", "/player/position/mean/1"},
    {"steps", "/player/responsiveness/steps"},
    {"silent", "/player/responsiveness/silent"},
    {"no_body_command", "/player/responsiveness/no_body_command"},
    {"rejected_kicks", "/player/responsiveness/rejected_kicks"},
    {"rating", "/player/rating/total"},
};

std::string format_number(double value) { return fmt::format("{}", rounded(value)); }

std::string format_cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? format_number(value.get<double>()) : value.dump();
}

base::Table empty_table(const std::vector<Column>& columns) {
  base::Table table;
  for (const Column& column : columns) table.add_column(column.name);
  return table;
}

void add_row(const std::vector<Column>& columns, const Json& row, base::Table& table) {
  std::vector<std::string> cells;
  for (const Column& column : columns) {
    const Json::json_pointer pointer(column.value);
    cells.push_back(row.contains(pointer) ? format_cell(row.at(pointer)) : std::string());
  }
  table.add_row(std::move(cells));
}

std::string unum_text(std::int8_t slot) {
  return slot == kNoPlayer ? std::string() : std::to_string(soccer::unum_of_slot(slot));
}

struct EventColumn {
  const char* name;
  std::string (*value)(const Event&);
};

const EventColumn kEventColumns[] = {
    {"cycle", [](const Event& event) { return std::to_string(event.cycle); }},
    {"stopped", [](const Event& event) { return std::to_string(event.stopped); }},
    {"kind", [](const Event& event) { return std::string(event.kind); }},
    {"side", [](const Event& event) { return std::string(side_text(event.slot)); }},
    {"unum", [](const Event& event) { return unum_text(event.slot); }},
    {"from_x", [](const Event& event) { return format_number(event.from.x); }},
    {"from_y", [](const Event& event) { return format_number(event.from.y); }},
    {"to_x", [](const Event& event) { return format_number(event.to.x); }},
    {"to_y", [](const Event& event) { return format_number(event.to.y); }},
    {"other_side", [](const Event& event) { return std::string(side_text(event.other)); }},
    {"other_unum", [](const Event& event) { return unum_text(event.other); }},
    {"result", [](const Event& event) { return std::string(event.result); }},
    {"marks", [](const Event& event) { return fmt::format("{}", fmt::join(event.marks, " ")); }},
};

}  // namespace

base::Table team_table() { return empty_table(kTeamColumns); }

void add_teams(const MatchSummary& summary, const MatchStatistics& all, base::Table& table) {
  for (std::size_t team = 0; team < 2; ++team) {
    const TeamTotals totals = sum_team(all, team);
    const TeamSummary& opponent = summary.teams[1 - team];
    const Json row = {{"file", summary.file},
                      {"side", team == 0 ? "left" : "right"},
                      {"opponent", {{"name", opponent.name}, {"score", opponent.score}}},
                      {"cycles", summary.cycles},
                      {"complete", summary.complete},
                      {"goals", totals.goals},
                      {"team", team_fields(summary, all, totals, team)}};
    add_row(kTeamColumns, row, table);
  }
}

base::Table player_table() { return empty_table(kPlayerColumns); }

void add_players(const MatchSummary& summary, const MatchStatistics& all, base::Table& table) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const Json row = {{"file", summary.file},
                      {"name", summary.teams[team_of(slot)].name},
                      {"player", player_fields(all, slot)}};
    add_row(kPlayerColumns, row, table);
  }
}

base::Table event_table() {
  base::Table table;
  table.add_column("file");
  for (const EventColumn& column : kEventColumns) table.add_column(column.name);
  return table;
}

void add_events(const MatchSummary& summary, const MatchStatistics& all, base::Table& table) {
  for (const Event& event : list_events(all)) {
    std::vector<std::string> cells = {summary.file};
    for (const EventColumn& column : kEventColumns) cells.push_back(column.value(event));
    table.add_row(std::move(cells));
  }
}

}  // namespace cls::analysis
