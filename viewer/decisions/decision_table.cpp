// Columns follow from decision_columns().
#include "viewer/decisions/decision_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/io/arrow_file.h"
#include "soccer/side.h"
#include "viewer/decisions/decision_columns.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::viewer {
namespace {

using base::ArrowField;
using base::ArrowType;

// In the order of kDecisionTexts.
constexpr std::array<const char*, kDecisionTexts.size()> kTextColumns = {"reply", "commands",
                                                                         "plan", "drawings"};

constexpr std::int64_t kMaxLatency = std::int64_t{1} << 52;  // files may contain anything

const char* unit_of(std::string_view column) {
  const auto ends = [column](std::string_view ending) { return column.ends_with(ending); };
  if (ends("_vx") || ends("_vy")) return "m/cycle";
  if (ends("_body") || ends("_neck")) return "deg";
  if (ends("x") || ends("y")) return "m";
  return ends("age") || ends("reach") || ends("cycle") || ends("stopped") ? "cycle" : "";
}

// Values in meters and degrees have fractions.
ArrowType type_of(const DecisionColumnSpec& column) {
  const std::string_view unit = unit_of(column.name);
  return unit.starts_with("m") || unit == "deg" ? ArrowType::kFloat32 : ArrowType::kInt32;
}

std::vector<ArrowField> fields() {
  std::vector<ArrowField> all = {
      {"side", ArrowType::kText}, {"team", ArrowType::kText}, {"unum", ArrowType::kInt8}};
  for (const DecisionColumnSpec& column : decision_columns()) {
    all.push_back({std::string(column.name), type_of(column), unit_of(column.name),
                   column.series == 1 ? 0 : column.series});
  }
  for (const char* name : kTextColumns) all.push_back({name, ArrowType::kText});
  all.push_back({"latency", ArrowType::kInt64, "us"});
  return all;
}

// Players of unknown number in their order; free places have id 0 and age kUnknownAge.
SlottedSample slotted(const DecisionSample& sample) {
  SlottedSample all{sample, {}};
  const std::size_t count = std::min(sample.unnumbered.size(), all.unnumbered.size());
  std::copy_n(sample.unnumbered.begin(), count, all.unnumbered.begin());
  return all;
}

}  // namespace

void write_decisions_arrow(const std::vector<TeamDecisions>& teams, base::ByteSink& sink) {
  base::ArrowWriter table(sink, fields(), {{"schema", "cls.world_models/1"}});
  for (const TeamDecisions& team : teams) {
    for (std::size_t player = 0; player < team.players.size(); ++player) {
      for (const DecisionSample& sample : team.players[player]) {
        const SlottedSample row = slotted(sample);
        table.add(std::string_view(soccer::side_name(team.side)));
        table.add(std::string_view(team.team));
        table.add(static_cast<double>(player + 1));
        for (const DecisionColumnSpec& column : decision_columns()) {
          for (std::size_t i = 0; i < column.series; ++i) table.add(column.load(row, i));
        }
        for (const auto text : kDecisionTexts) table.add(std::string_view(sample.*text));
        table.add(static_cast<double>(std::clamp<std::int64_t>(sample.latency_us, 0, kMaxLatency)));
      }
    }
  }
  table.close();
}

}  // namespace cls::viewer
