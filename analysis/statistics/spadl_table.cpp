// One row for each action.
#include "analysis/statistics/spadl_actions.h"

#include <array>
#include <string>
#include <vector>

#include "analysis/results/periods.h"
#include "base/text/number_text.h"
#include "soccer/side.h"

namespace cls::analysis {
namespace {

std::string number(double value) {
  std::string text;
  base::append_g(value, text);
  return text;
}

template <typename Enum>
std::string id(Enum value) {
  return std::to_string(static_cast<int>(value));
}

}  // namespace

base::Table spadl_table() {
  base::Table table;
  table.add_columns({"game_id", "original_event_id", "action_id", "period_id", "time_seconds",
                     "team_id", "player_id", "start_x", "start_y", "end_x", "end_y", "type_id",
                     "type_name", "result_id", "result_name", "bodypart_id", "bodypart_name"});
  return table;
}

void add_spadl(const MatchSummary& summary, const MatchStatistics& statistics, base::Table& table) {
  const gamelog::MatchRecord& record = *statistics.flow.record;
  const std::vector<Period> periods = find_periods(record);
  const std::array<std::string, 2> teams = team_ids(summary);
  int index = 0;
  for (const SpadlAction& action : spadl_actions(statistics)) {
    const Period& period = period_of(periods, action.frame);
    const int cycles = record.time[action.frame] - period.start_cycle;
    const std::string& team = teams[team_of(slot_index(action.slot))];
    table.add_row(
        {summary.file, action.event ? std::to_string(*action.event) : "", std::to_string(index++),
         id(period.kind), number(cycles * cycle_seconds(record.server)), team,
         team + "_" + std::to_string(soccer::unum_of_slot(action.slot)), number(action.start.x),
         number(action.start.y), number(action.end.x), number(action.end.y), id(action.type),
         std::string(name(action.type)), id(action.result), std::string(name(action.result)),
         id(action.body_part), std::string(name(action.body_part))});
  }
}

}  // namespace cls::analysis
