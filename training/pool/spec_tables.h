// The catalog as tables for people: tasks, feature sets, action sets, rewards, statuses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/table.h"
#include "training/actions/action_set.h"
#include "training/features/feature_set.h"
#include "training/tasks/task.h"

namespace cls::training {

struct SpecTable {
  std::string heading;
  std::string note;  ///< below the heading; may be empty
  base::Table table;
};

/// All of it, one line per item.
std::vector<SpecTable> overview_tables();

/// One item with its options, columns or parameters. A feature set has the columns for so many
/// teammates (without the agent) and opponents.
std::vector<SpecTable> tables_of(const Task& task);
std::vector<SpecTable> tables_of(const FeatureSet& set, int teammates, int opponents);
std::vector<SpecTable> tables_of(const ActionSet& set);

/// "cls/HalfFieldOffense-v0"
std::string full_id(const Task& task);

/// Names of all tasks, feature sets and action sets; they are distinct.
std::vector<std::string_view> spec_names();

/// Headings, notes and tables. `width` of the lines; 0: unlimited.
std::string format_text(const std::vector<SpecTable>& tables, std::size_t width);
/// Headings are of the third level.
std::string format_markdown(const std::vector<SpecTable>& tables);

}  // namespace cls::training
