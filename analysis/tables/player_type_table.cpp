// Reads the lines of the log again, because the record has types by number and not in order.
#include "analysis/tables/log_tables.h"

#include <fmt/format.h>

#include <string_view>
#include <variant>
#include <vector>

#include "base/text/number_text.h"
#include "base/text/split.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/player_type.h"

namespace cls::analysis {
namespace {

// Behind the column "id".
constexpr std::string_view kTypeColumns =
    "player_speed_max,stamina_inc_max,player_decay,inertia_moment,dash_power_rate,player_size,"
    "kickable_margin,kick_rand,extra_stamina,effort_max,effort_min,kick_power_rate,"
    "foul_detect_probability,catchable_area_l_stretch";

}  // namespace

std::string player_type_table(const gamelog::MatchRecord& record) {
  const std::vector<std::string_view> columns = base::split(kTypeColumns, ',');
  std::string table;
  for (const std::string& line : record.parameter_lines) {
    soccer::PlayerType type;
    if (!line.starts_with("(player_type ") || !soccer::parse(line, type)) continue;

    if (table.empty()) table = fmt::format("id,{}\n", kTypeColumns);
    base::append_int(type.id, table);
    for (const std::string_view column : columns) {
      const auto* row = soccer::find_parameter(soccer::player_type_table(), column);
      table += ',';
      base::append_g(type.*std::get<double soccer::PlayerType::*>(row->member), table);
    }
    table += '\n';
  }
  return table;
}

}  // namespace cls::analysis
