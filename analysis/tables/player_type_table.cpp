// Reads the lines of the log again, because the record has types by number and not in order.
#include "analysis/tables/log_tables.h"

#include <array>

#include "base/text/number_text.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/player_type.h"

namespace cls::analysis {
namespace {

using soccer::PlayerType;

constexpr const char* kHeading =
    "id,player_speed_max,stamina_inc_max,player_decay,inertia_moment,dash_power_rate,player_size,"
    "kickable_margin,kick_rand,extra_stamina,effort_max,effort_min,kick_power_rate,"
    "foul_detect_probability,catchable_area_l_stretch\n";

constexpr std::array kValues = {&PlayerType::player_speed_max,
                                &PlayerType::stamina_inc_max,
                                &PlayerType::player_decay,
                                &PlayerType::inertia_moment,
                                &PlayerType::dash_power_rate,
                                &PlayerType::player_size,
                                &PlayerType::kickable_margin,
                                &PlayerType::kick_rand,
                                &PlayerType::extra_stamina,
                                &PlayerType::effort_max,
                                &PlayerType::effort_min,
                                &PlayerType::kick_power_rate,
                                &PlayerType::foul_detect_probability,
                                &PlayerType::catchable_area_l_stretch};

}  // namespace

std::string player_type_table(const gamelog::MatchRecord& record) {
  std::string table;
  for (const std::string& line : record.parameter_lines) {
    if (!line.starts_with("(player_type ")) continue;
    PlayerType type;
    if (!soccer::parse(line, type)) continue;
    if (table.empty()) table = kHeading;
    base::append_int(type.id, table);
    for (const auto value : kValues) {
      table += ',';
      base::append_g(type.*value, table);
    }
    table += '\n';
  }
  return table;
}

}  // namespace cls::analysis
