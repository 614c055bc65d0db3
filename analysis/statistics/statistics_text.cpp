// Formats the report of one match.
#include "analysis/statistics/statistics_text.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <vector>

#include "analysis/results/results_text.h"
#include "analysis/statistics/field_table.h"
#include "base/text/printable.h"
#include "base/text/wrap_text.h"

namespace cls::analysis {
namespace {

using Align = base::Table::Align;

double scaled(double value, Scale scale) {
  if (scale == Scale::kPercent) return 100 * value;
  return scale == Scale::kKilometers ? value / 1000 : value;
}

// "-" if a value is missing.
std::string format_figure(const auto& figure, const auto& view) {
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const auto& statistic : figure.statistics) {
    if (statistic.row == nullptr) break;
    const std::optional<Json> value = statistic.row->value(view);
    if (!value) return "-";

    if (value->is_string()) {
      values.push_back(value->get<std::string>());
    } else if (value->is_number_float()) {
      values.push_back(scaled(value->get<double>(), figure.scale));
    } else {
      values.push_back(value->get<int>());
    }
  }

  const std::string text = fmt::vformat(figure.format, values);
  return text == "-0.0" ? "0.0" : text;
}

}  // namespace

base::Table team_figures(const MatchSummary& summary, const MatchStatistics& all) {
  base::Table table;
  table.add_column("");
  for (const TeamSummary& team : summary.teams) table.add_column(team.name, Align::kRight);

  const TeamView left = {summary, all, 0};
  const TeamView right = {summary, all, 1};
  for (const auto& figure : kTeamFigures) {
    const std::string text = format_figure(figure, left);
    if (text != "-") table.add_row({figure.heading, text, format_figure(figure, right)});
  }
  return table;
}

base::Table player_figures(const MatchSummary& summary, const MatchStatistics& all) {
  base::Table table;
  table.add_column("player");
  for (const auto& figure : kPlayerFigures) table.add_column(figure.heading, Align::kRight);

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    if (all.attention[slot].frames == 0) continue;
    const PlayerView player = {summary, all, slot};
    std::vector<std::string> cells = {
        fmt::format("{} {}", summary.teams[team_of(slot)].name, unum_of(slot))};
    for (const auto& figure : kPlayerFigures) cells.push_back(format_figure(figure, player));
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
