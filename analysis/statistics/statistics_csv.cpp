// CSV tables of teams, players and events.
#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/field_table.h"
#include "analysis/statistics/statistics_text.h"

namespace cls::analysis {
namespace {

/// A column, and the JSON pointer of its value in a row: of a statistic, or of what the row says
/// about the match. Missing values give empty cells.
struct Column {
  const char* name;
  const char* value;
  const char* parent = "";

  constexpr Column(const char* column, const char* own) : name(column), value(own) {}
  constexpr Column(const char* column, TeamPath path)
      : name(column), value(path.text), parent("/team") {}
  constexpr Column(const char* column, PlayerPath path)
      : name(column), value(path.text), parent("/player") {}
};

constexpr Column kTeamColumns[] = {
    {"file", "/file"},
    {"side", "/side"},
    {"name", TeamPath{"/name"}},
    {"score", TeamPath{"/score"}},
    {"opponent", "/opponent/name"},
    {"opponent_score", "/opponent/score"},
    {"cycles", "/cycles"},
    {"complete", "/complete"},
    {"possession", TeamPath{"/possession/last_touch"}},
    {"possession_at_feet", TeamPath{"/possession/at_feet"}},
    {"possession_fastest", TeamPath{"/possession/fastest"}},
    {"touches", TeamPath{"/touches"}},
    {"passes", TeamPath{"/passes/attempted"}},
    {"completed", TeamPath{"/passes/completed"}},
    {"mean_pass", TeamPath{"/passes/mean_length"}},
    {"through", TeamPath{"/passes/through"}},
    {"crosses", TeamPath{"/passes/crosses"}},
    {"one_twos", TeamPath{"/passes/one_twos"}},
    {"dribbles", TeamPath{"/dribbles"}},
    {"take_ons", TeamPath{"/take_ons"}},
    {"shots", TeamPath{"/shots/total"}},
    {"on_target", TeamPath{"/shots/on_target"}},
    {"goals", "/goals"},
    {"expected_goals", TeamPath{"/shots/expected_goals"}},
    {"tackles", TeamPath{"/tackles/tried"}},
    {"tackles_hit", TeamPath{"/tackles/succeeded"}},
    {"tackles_effective", TeamPath{"/tackles/effective"}},
    {"interceptions", TeamPath{"/interceptions"}},
    {"recoveries", TeamPath{"/pressing/recoveries"}},
    {"box_entries", TeamPath{"/territory/box_entries"}},
    {"box_touches", TeamPath{"/territory/box_touches"}},
    {"final_third_touches", TeamPath{"/territory/final_third_touches"}},
    {"pitch_control", TeamPath{"/territory/pitch_control"}},
    {"corners", TeamPath{"/stoppages/corners"}},
    {"kick_ins", TeamPath{"/stoppages/kick_ins"}},
    {"goal_kicks", TeamPath{"/stoppages/goal_kicks"}},
    {"free_kicks", TeamPath{"/stoppages/free_kicks"}},
    {"indirect_free_kicks", TeamPath{"/stoppages/indirect_free_kicks"}},
    {"catches", TeamPath{"/goalkeeping/catches"}},
    {"saves", TeamPath{"/goalkeeping/saves"}},
    {"offsides", TeamPath{"/stoppages/offsides"}},
    {"fouls", TeamPath{"/stoppages/fouls"}},
    {"yellow", TeamPath{"/stoppages/yellow_cards"}},
    {"red", TeamPath{"/stoppages/red_cards"}},
    {"distance", TeamPath{"/distance"}},
    {"stamina_used", TeamPath{"/stamina_used"}},
    {"exhausted_frames", TeamPath{"/exhausted_frames"}},
    {"silent_steps", TeamPath{"/silent_steps"}},
    {"rejected_commands", TeamPath{"/rejected_commands"}},
};

constexpr Column kPlayerColumns[] = {
    {"file", "/file"},
    {"side", PlayerPath{"/side"}},
    {"name", "/name"},
    {"unum", PlayerPath{"/unum"}},
    {"frames", PlayerPath{"/frames"}},
    {"touches", PlayerPath{"/ball/touches"}},
    {"passes", PlayerPath{"/ball/passes"}},
    {"completed", PlayerPath{"/ball/completed"}},
    {"received", PlayerPath{"/ball/received"}},
    {"key_passes", PlayerPath{"/ball/key_passes"}},
    {"assists", PlayerPath{"/ball/assists"}},
    {"dribbles", PlayerPath{"/ball/dribbles"}},
    {"take_ons", PlayerPath{"/ball/take_ons"}},
    {"shots", PlayerPath{"/ball/shots"}},
    {"on_target", PlayerPath{"/ball/on_target"}},
    {"goals", PlayerPath{"/ball/goals"}},
    {"own_goals", PlayerPath{"/ball/own_goals"}},
    {"expected_goals", PlayerPath{"/ball/expected_goals"}},
    {"threat_added", PlayerPath{"/ball/threat_added"}},
    {"tackles", PlayerPath{"/tackles/tried"}},
    {"tackles_hit", PlayerPath{"/tackles/succeeded"}},
    {"interceptions", PlayerPath{"/interceptions"}},
    {"recoveries", PlayerPath{"/recoveries"}},
    {"losses", PlayerPath{"/ball/losses"}},
    {"fouls", PlayerPath{"/fouls"}},
    {"fouled", PlayerPath{"/fouled"}},
    {"yellow", PlayerPath{"/yellow_cards"}},
    {"red", PlayerPath{"/red_cards"}},
    {"distance", PlayerPath{"/movement/distance"}},
    {"top_speed", PlayerPath{"/movement/top_speed"}},
    {"stamina_used", PlayerPath{"/stamina/used"}},
    {"lowest_stamina", PlayerPath{"/stamina/lowest"}},
    {"exhausted_frames", PlayerPath{"/stamina/exhausted_frames"}},
    {"mean_x", PlayerPath{"/position/mean/0"}},
    {"mean_y", PlayerPath{"/position/mean/1"}},
    {"steps", PlayerPath{"/responsiveness/steps"}},
    {"silent", PlayerPath{"/responsiveness/silent"}},
    {"no_body_command", PlayerPath{"/responsiveness/no_body_command"}},
    {"rejected_kicks", PlayerPath{"/responsiveness/rejected_kicks"}},
    {"rating", PlayerPath{"/rating/total"}},
};

std::string format_number(double value) { return fmt::format("{}", rounded(value)); }

std::string format_cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? format_number(value.get<double>()) : value.dump();
}

base::Table empty_table(std::span<const Column> columns) {
  base::Table table;
  for (const Column& column : columns) table.add_column(column.name);
  return table;
}

void add_row(std::span<const Column> columns, const Json& row, base::Table& table) {
  std::vector<std::string> cells;
  for (const Column& column : columns) {
    const Json::json_pointer pointer(std::string(column.parent) + column.value);
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
