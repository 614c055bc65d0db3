// CSV tables of teams, players and events.
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/event_list.h"
#include "analysis/statistics/field_table.h"
#include "analysis/statistics/statistics_text.h"

namespace cls::analysis {
namespace {

std::string format_number(double value) { return fmt::format("{}", rounded(value)); }

std::string format_cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number_float() ? format_number(value.get<double>()) : value.dump();
}

template <class Rows>
base::Table table_of(const Rows& rows) {
  base::Table table;
  for (const auto& row : rows) {
    if (row.column != nullptr) table.add_column(row.column);
  }
  return table;
}

// Values that the match does not have give empty cells.
template <class View>
void add_row(const auto& rows, const View& view, base::Table& table) {
  std::vector<std::string> cells;
  for (const Field<View>& row : rows) {
    if (row.column == nullptr) continue;
    const std::optional<Json> value = row.value(view);
    cells.push_back(value ? format_cell(*value) : "");
  }
  table.add_row(std::move(cells));
}

std::string unum_text(std::int8_t slot) {
  return slot == kNoPlayer ? std::string() : std::to_string(unum_of(slot));
}

struct EventColumn {
  const char* heading;
  std::string (*value)(const Event&);
};

constexpr EventColumn kEventColumns[] = {
    {"cycle", [](const Event& event) { return std::to_string(event.cycle); }},
    {"stopped", [](const Event& event) { return std::to_string(event.stopped); }},
    {"kind", [](const Event& event) { return std::string(name(event.kind)); }},
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

base::Table team_table() { return table_of(kTeamFields); }

void add_teams(const MatchSummary& summary, const MatchStatistics& all, base::Table& table) {
  for (std::size_t team = 0; team < 2; ++team) {
    add_row(kTeamFields, TeamView{summary, all, team}, table);
  }
}

base::Table player_table() { return table_of(kPlayerFields); }

void add_players(const MatchSummary& summary, const MatchStatistics& all, base::Table& table) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    add_row(kPlayerFields, PlayerView{summary, all, slot}, table);
  }
}

base::Table event_table() {
  base::Table table;
  table.add_column("file");
  for (const EventColumn& column : kEventColumns) table.add_column(column.heading);
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
