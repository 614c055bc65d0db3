// Formats the report of one match.
#include "analysis/statistics/statistics_text.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "analysis/results/results_text.h"
#include "analysis/statistics/field_table.h"
#include "base/text/printable.h"
#include "base/text/wrap_text.h"

namespace cls::analysis {
namespace {

using Align = base::Table::Align;

enum class Scale { kNone, kPercent, kKilometers };

/// A figure of the report: a format for the values at paths of statistics. "-" if a value is
/// missing.
template <class Path>
struct Figure {
  const char* heading;
  const char* format;
  std::vector<Path> values;
  Scale scale = Scale::kNone;
};

const std::vector<Figure<TeamPath>> kTeamFigures = {
    {"possession (last touch)", "{:.1f} %", {"/possession/last_touch"}, Scale::kPercent},
    {"ball at feet", "{:.1f} %", {"/possession/at_feet"}, Scale::kPercent},
    {"fastest to the ball", "{:.1f} %", {"/possession/fastest"}, Scale::kPercent},
    {"touches", "{}", {"/touches"}},
    {"passes completed", "{} of {}", {"/passes/completed", "/passes/attempted"}},
    {"mean pass", "{:.1f} m", {"/passes/mean_length"}},
    {"through passes, crosses, one-twos",
     "{}, {}, {}",
     {"/passes/through", "/passes/crosses", "/passes/one_twos"}},
    {"dribbles, take-ons", "{}, {}", {"/dribbles", "/take_ons"}},
    {"shots on target", "{} of {}", {"/shots/on_target", "/shots/total"}},
    {"goal, saved, blocked, wide, post",
     "{}, {}, {}, {}, {}",
     {"/shots/goal", "/shots/saved", "/shots/blocked", "/shots/wide", "/shots/post"}},
    {"expected goals", "{:.2f}", {"/shots/expected_goals"}},
    {"box entries, touches in the box",
     "{}, {}",
     {"/territory/box_entries", "/territory/box_touches"}},
    {"pitch control", "{:.1f} %", {"/territory/pitch_control"}, Scale::kPercent},
    {"successful tackles", "{} of {}", {"/tackles/succeeded", "/tackles/tried"}},
    {"interceptions, recoveries", "{}, {}", {"/interceptions", "/pressing/recoveries"}},
    {"opponent passes per defensive action", "{:.1f}", {"/pressing/passes_per_action"}},
    {"saves, catches", "{}, {}", {"/goalkeeping/saves", "/goalkeeping/catches"}},
    {"offsides, fouls", "{}, {}", {"/stoppages/offsides", "/stoppages/fouls"}},
    {"yellow, red cards", "{}, {}", {"/stoppages/yellow_cards", "/stoppages/red_cards"}},
    {"kick-ins, corners, goal kicks",
     "{}, {}, {}",
     {"/stoppages/kick_ins", "/stoppages/corners", "/stoppages/goal_kicks"}},
    {"free kicks, indirect", "{}, {}", {"/stoppages/free_kicks", "/stoppages/indirect_free_kicks"}},
    {"distance", "{:.1f} km", {"/distance"}, Scale::kKilometers},
    {"formation", "{}", {"/shape/formation"}},
    {"length x width", "{:.0f} x {:.0f} m", {"/shape/length", "/shape/width"}},
};

const std::vector<Figure<PlayerPath>> kPlayerFigures = {
    {"touches", "{}", {"/ball/touches"}},
    {"passes", "{} of {}", {"/ball/completed", "/ball/passes"}},
    {"dribbles", "{}", {"/ball/dribbles"}},
    {"shots", "{} of {}", {"/ball/on_target", "/ball/shots"}},
    {"goals", "{}", {"/ball/goals"}},
    {"tackles", "{} of {}", {"/tackles/succeeded", "/tackles/tried"}},
    {"recoveries", "{}", {"/recoveries"}},
    {"losses", "{}", {"/ball/losses"}},
    {"fouls", "{}", {"/fouls"}},
    {"meters", "{:.0f}", {"/movement/distance"}},
    {"stamina", "{:.0f}", {"/stamina/used"}},
    {"silent", "{}", {"/responsiveness/silent"}},
    {"rating", "{:.1f}", {"/rating/total"}},
};

double scaled(double value, Scale scale) {
  if (scale == Scale::kPercent) return 100 * value;
  return scale == Scale::kKilometers ? value / 1000 : value;
}

template <class Path>
std::string format_figure(const Figure<Path>& figure, const Json& fields) {
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const Path& path : figure.values) {
    const Json::json_pointer pointer(path.text);
    if (!fields.contains(pointer)) return "-";
    const Json& value = fields.at(pointer);
    if (value.is_string()) {
      values.push_back(value.get<std::string>());
    } else if (value.is_number_float()) {
      values.push_back(scaled(value.get<double>(), figure.scale));
    } else {
      values.push_back(value.get<int>());
    }
  }
  const std::string text = fmt::vformat(figure.format, values);
  return text == "-0.0" ? "0.0" : text;
}

}  // namespace

base::Table team_figures(const MatchSummary& summary, const MatchStatistics& all) {
  const PerTeam<TeamTotals> totals = {sum_team(all, 0), sum_team(all, 1)};
  const PerTeam<Json> fields = {team_fields(summary, all, totals[0], 0),
                                team_fields(summary, all, totals[1], 1)};
  base::Table table;
  table.add_column("");
  table.add_column(summary.teams[0].name, Align::kRight);
  table.add_column(summary.teams[1].name, Align::kRight);
  for (const auto& figure : kTeamFigures) {
    table.add_row(
        {figure.heading, format_figure(figure, fields[0]), format_figure(figure, fields[1])});
  }
  if (all.responsiveness) {
    const auto silent = [&](std::size_t team) {
      return fmt::format("{} of {}", totals[team].silent, totals[team].steps);
    };
    table.add_row({"silent steps", silent(0), silent(1)});
    table.add_row({"rejected commands", std::to_string(totals[0].rejected),
                   std::to_string(totals[1].rejected)});
  }
  return table;
}

base::Table player_figures(const MatchSummary& summary, const MatchStatistics& all) {
  base::Table table;
  table.add_column("player");
  for (const auto& figure : kPlayerFigures) table.add_column(figure.heading, Align::kRight);
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (all.attention[slot].frames == 0) continue;
    const Json fields = player_fields(all, slot);
    std::vector<std::string> cells = {fmt::format("{} {}", summary.teams[team_of(slot)].name,
                                                  soccer::unum_of_slot(static_cast<int>(slot)))};
    for (const auto& figure : kPlayerFigures) cells.push_back(format_figure(figure, fields));
    table.add_row(std::move(cells));
  }
  return table;
}

std::string statistics_text(const MatchSummary& summary, const MatchStatistics& all,
                            std::size_t width) {
  const auto& [left, right] = summary.teams;
  std::string text = fmt::format("{} {} {}  ({} cycles, {} of {} frames in play)\n", left.name,
                                 score_text(summary), right.name, summary.cycles,
                                 all.territory.live_frames, all.territory.frames);
  for (const std::string& reason : exclusion_reasons(summary, all)) {
    text += "warning: " + reason + "\n";
  }
  text = base::wrap_text(base::printable_lines(text), width);
  text += '\n';
  text += team_figures(summary, all).format_text({0, width});
  text += '\n';
  text += player_figures(summary, all).format_text({0, width});
  return text;
}

}  // namespace cls::analysis
