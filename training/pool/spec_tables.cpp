// Builds the tables from the lists of tasks, sets and terms.
#include "training/pool/spec_tables.h"

#include <fmt/format.h>

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

std::string_view text_of(Agents agents) {
  return agents == Agents::kLeft ? "offense" : agents == Agents::kRight ? "defense" : "both";
}

SpecTable task_table() {
  Table table;
  table.add_columns(
      {"task", "offense", "defense", "agents", "cycles", "features", "actions", "summary"});
  table.allow_cuts(7);

  for (const Task& task : tasks()) {
    table.add_row({full_id(task), text_of(task.offense), text_of(task.defense),
                   std::string(text_of(task.agents)), std::to_string(task.max_cycles),
                   std::string(task.features), std::string(task.actions),
                   std::string(task.summary)});
  }
  return {"Tasks",
          "Players of the left team (offense) and of the right team (defense), with the default "
          "in parentheses; agents, features and actions are defaults too.",
          std::move(table)};
}

SpecTable feature_set_table() {
  Table table;
  table.add_columns({"features", "version", "1v0", "2v2", "11v11", "for", "summary"});
  table.allow_cuts(6);

  for (const FeatureSet* set : feature_sets()) {
    const auto count = [set](int teammates, int opponents) {
      return std::to_string(set->columns(teammates, opponents).size());
    };
    table.add_row({std::string(set->name), std::to_string(set->version), count(0, 0), count(1, 2),
                   count(10, 11), set->left_only ? "offense" : "both", std::string(set->summary)});
  }
  return {"Feature sets", "How many numbers an agent observes depends on the players.",
          std::move(table)};
}

SpecTable action_set_table() {
  Table table;
  table.add_columns({"actions", "version", "ids", "values", "summary"});
  table.allow_cuts(4);
  for (const ActionSet* set : action_sets()) {
    table.add_row({std::string(set->name), std::to_string(set->version),
                   std::to_string(set->id_count()), std::to_string(set->values().size()),
                   std::string(set->summary)});
  }
  return {"Action sets", "", std::move(table)};
}

SpecTable reward_table() {
  Table table;
  table.add_columns({"term", "weight", "unit", "low", "high", "summary"});
  table.allow_cuts(5);

  for (const RewardTerm& term : reward_terms()) {
    table.add_row({std::string(term.name), fmt::format("{}", term.weight), std::string(term.unit),
                   fmt::format("{}", term.low), fmt::format("{}", term.high),
                   std::string(term.summary)});
  }
  return {"Reward terms",
          fmt::format("Version {}. A reward is the sum of the terms times their weights; bounds "
                      "are those of one cycle.",
                      kRewardVersion),
          std::move(table)};
}

SpecTable status_table() {
  Table table;
  table.add_columns({"number", "status", "ends as", "summary"});
  table.allow_cuts(3);
  for (std::size_t i = 0; i < statuses().size(); ++i) {
    const StatusInfo& status = statuses()[i];
    const char* end = i == 0 ? "-" : status.truncated ? "truncated" : "terminated";
    table.add_row({std::to_string(i), std::string(status.name), end, std::string(status.summary)});
  }
  return {"Statuses", "How an episode ended: `info[\"status\"]`.", std::move(table)};
}

Table column_table() {
  Table table;
  table.add_column("index", Align::kRight);
  table.add_columns({"name", "unit", "low", "high"});
  return table;
}

void add_column_row(std::size_t index, const Column& column, Table& table) {
  table.add_row({std::to_string(index), column.name, column.unit, fmt::format("{}", column.low),
                 fmt::format("{}", column.high)});
}

}  // namespace

std::string full_id(const Task& task) { return fmt::format("cls/{}-v{}", task.id, task.version); }

std::vector<SpecTable> overview_tables() {
  std::vector<SpecTable> all;
  all.push_back(task_table());
  all.push_back(feature_set_table());
  all.push_back(action_set_table());
  all.push_back(reward_table());
  all.push_back(status_table());
  return all;
}

std::vector<SpecTable> tables_of(const Task& task) {
  Table table;
  table.add_columns({"option", "default", "low", "high", "summary"});
  table.allow_cuts(4);

  for (const TaskOption& option : task.options) {
    table.add_row({std::string(option.name), fmt::format("{}", option.value),
                   fmt::format("{}", option.low), fmt::format("{}", option.high),
                   std::string(option.summary)});
  }

  std::vector<SpecTable> all;
  all.push_back(
      {full_id(task),
       fmt::format("{}. Offense {}, defense {}, agents: {}, at most {} cycles, {}. Defaults: "
                   "features {}, actions {}.",
                   task.summary, text_of(task.offense), text_of(task.defense), text_of(task.agents),
                   task.max_cycles,
                   task.referee ? "the full referee" : "only the rules of the task", task.features,
                   task.actions),
       std::move(table)});
  return all;
}

std::vector<SpecTable> tables_of(const FeatureSet& set, int teammates, int opponents) {
  Table table = column_table();
  const Columns columns = set.columns(teammates, opponents);
  for (std::size_t i = 0; i < columns.size(); ++i) add_column_row(i, columns[i], table);

  std::vector<SpecTable> all;
  all.push_back(
      {fmt::format("{}, version {}", set.name, set.version),
       fmt::format("{}. {} numbers for {} and {}.", set.summary, columns.size(),
                   base::counted(teammates, "teammate"), base::counted(opponents, "opponent")),
       std::move(table)});
  return all;
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
      const Action& action = set.actions[id];
      table.add_row({std::to_string(id), std::string(action.name),
                     action.legal == nullptr ? "always" : "where the mask is 1"});
    }
    all.push_back({heading, note, std::move(table)});
  }

  const Columns values = set.values();
  if (values.empty()) return all;
  Table table = column_table();
  for (std::size_t i = 0; i < values.size(); ++i) add_column_row(i, values[i], table);
  all.push_back({all.empty() ? heading : "Values", all.empty() ? note : "", std::move(table)});
  return all;
}

std::vector<std::string_view> spec_names() {
  std::vector<std::string_view> names;
  for (const Task& task : tasks()) names.push_back(task.id);
  for (const FeatureSet* set : feature_sets()) names.push_back(set->name);
  for (const ActionSet* set : action_sets()) names.push_back(set->name);
  return names;
}

std::string format_text(const std::vector<SpecTable>& tables, std::size_t width) {
  std::string out;
  for (const SpecTable& part : tables) {
    if (!out.empty()) out += '\n';
    out += part.heading + '\n';
    if (!part.note.empty()) out += part.note + '\n';

    base::TextLayout layout;
    layout.indent = 2;
    layout.width = width;
    out += part.table.format_text(layout);
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
