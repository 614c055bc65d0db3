// Builds the tables from the lists of tasks, sets and terms.
#include "training/pool/spec_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text/counted.h"
#include "training/episode/reward.h"

namespace cls::training {
namespace {

using base::Table;
using Align = Table::Align;

// "1..10 (2)": the default in parentheses.
std::string text_of(const Range& range) {
  if (range.low == range.high) return std::to_string(range.low);
  return fmt::format("{}..{} ({})", range.low, range.high, range.usual);
}

/// A table whose last column may be cut.
Table table_with(const std::vector<std::string_view>& headings) {
  Table table;
  table.add_columns(headings);
  table.allow_cuts(headings.size() - 1);
  return table;
}

template <typename... Cells>
void add_row(Table& table, const Cells&... cells) {
  table.add_row({fmt::format("{}", cells)...});
}

SpecTable task_table() {
  Table table = table_with(
      {"task", "offense", "defense", "agents", "cycles", "features", "actions", "summary"});
  for (const Task& task : tasks()) {
    add_row(table, full_id(task), text_of(task.offense), text_of(task.defense),
            kAgentsNames.name(task.agents), task.max_cycles, task.features, task.actions,
            task.summary);
  }

  return {"Tasks",
          "Players of the left team (offense) and of the right team (defense), with the default "
          "in parentheses; agents, features and actions are defaults too.",
          std::move(table)};
}

SpecTable feature_set_table() {
  Table table = table_with({"features", "version", "1v0", "2v2", "11v11", "for", "summary"});
  for (const FeatureSet* set : feature_sets()) {
    add_row(table, set->name, set->version, set->columns(0, 0).size(), set->columns(1, 2).size(),
            set->columns(10, 11).size(), set->left_only ? "offense" : "both", set->summary);
  }

  return {"Feature sets", "How many numbers an agent observes depends on the players.",
          std::move(table)};
}

SpecTable action_set_table() {
  Table table = table_with({"actions", "version", "ids", "values", "summary"});
  for (const ActionSet* set : action_sets()) {
    add_row(table, set->name, set->version, set->id_count(), set->values().size(), set->summary);
  }
  return {"Action sets", "", std::move(table)};
}

SpecTable reward_table() {
  Table table = table_with({"term", "weight", "unit", "low", "high", "summary"});
  for (const RewardTerm& term : reward_terms()) {
    add_row(table, term.name, term.weight, term.unit, term.low, term.high, term.summary);
  }

  return {"Reward terms",
          fmt::format("Version {}. A reward is the sum of the terms times their weights; bounds "
                      "are those of one cycle.",
                      kRewardVersion),
          std::move(table)};
}

SpecTable status_table() {
  Table table = table_with({"number", "status", "ends as", "summary"});
  for (std::size_t i = 0; i < statuses().size(); ++i) {
    const StatusInfo& status = statuses()[i];
    add_row(table, i, status.name,
            i == 0             ? "-"
            : status.truncated ? "truncated"
                               : "terminated",
            status.summary);
  }
  return {"Statuses", "How an episode ended: `info[\"status\"]`.", std::move(table)};
}

Table table_of(const Columns& columns) {
  Table table;
  table.add_column("index", Align::kRight);
  table.add_columns({"name", "unit", "low", "high"});
  for (std::size_t i = 0; i < columns.size(); ++i) {
    add_row(table, i, columns[i].name, columns[i].unit, columns[i].low, columns[i].high);
  }
  return table;
}

}  // namespace

std::string full_id(const Task& task) { return fmt::format("cls/{}-v{}", task.id, task.version); }

std::vector<SpecTable> overview_tables() {
  return {task_table(), feature_set_table(), action_set_table(), reward_table(), status_table()};
}

std::vector<SpecTable> tables_of(const Task& task) {
  Table table = table_with({"option", "default", "low", "high", "summary"});
  for (const TaskOption& option : task.options) {
    add_row(table, option.name, option.value, option.low, option.high, option.summary);
  }

  return {{full_id(task),
           fmt::format("{}. Offense {}, defense {}, agents: {}, at most {} cycles, {}. Defaults: "
                       "features {}, actions {}.",
                       task.summary, text_of(task.offense), text_of(task.defense),
                       kAgentsNames.name(task.agents), task.max_cycles,
                       task.referee ? "the full referee" : "only the rules of the task",
                       task.features, task.actions),
           std::move(table)}};
}

std::vector<SpecTable> tables_of(const FeatureSet& set, int teammates, int opponents) {
  const Columns columns = set.columns(teammates, opponents);
  return {{fmt::format("{}, version {}", set.name, set.version),
           fmt::format("{}. {} numbers for {} and {}.", set.summary, columns.size(),
                       base::counted(teammates, "teammate"), base::counted(opponents, "opponent")),
           table_of(columns)}};
}

std::vector<SpecTable> tables_of(const ActionSet& set) {
  std::vector<SpecTable> all;
  const std::string heading = fmt::format("{}, version {}", set.name, set.version);
  const std::string note = fmt::format("{}.", set.summary);

  if (!set.actions.empty()) {
    Table table;
    table.add_column("id", Align::kRight);
    table.add_columns({"action", "has an effect"});
    for (std::size_t id = 0; id < set.actions.size(); ++id) {
      add_row(table, id, set.actions[id].name,
              set.actions[id].legal != nullptr || set.options ? "where the mask is 1" : "always");
    }
    all.push_back({heading, note, std::move(table)});
  }

  const Columns values = set.values();
  if (values.empty()) return all;
  all.push_back({all.empty() ? heading : "Values", all.empty() ? note : "", table_of(values)});
  return all;
}

std::vector<std::string_view> spec_names() {
  std::vector<std::string_view> names;
  for (const Task& task : tasks()) names.push_back(task.id);
  for (const FeatureSet* set : feature_sets()) {
    if (std::ranges::find(names, set->name) == names.end()) names.push_back(set->name);
  }
  for (const ActionSet* set : action_sets()) names.push_back(set->name);
  return names;
}

std::string format_text(const std::vector<SpecTable>& tables, std::size_t width) {
  std::string out;
  for (const SpecTable& part : tables) {
    if (!out.empty()) out += '\n';
    out += part.heading + '\n';
    if (!part.note.empty()) out += part.note + '\n';

    out += part.table.format_text({.indent = 2, .width = width});
  }
  return out;
}

std::string format_markdown(const std::vector<SpecTable>& tables) {
  std::string out;
  for (const SpecTable& part : tables) {
    if (!out.empty()) out += '\n';
    out += fmt::format("### {}\n\n", part.heading);
    if (!part.note.empty()) out += part.note + "\n\n";
    out += part.table.format_markdown();
  }
  return out;
}

}  // namespace cls::training
