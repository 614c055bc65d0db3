// The rows of the tables that commands print: what `cls explain summary` lists.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace cls::cli {

struct TableRow {
  std::string_view command;  ///< "cls match", "cls stats"
  std::string_view label;    ///< as printed
  std::string_view meaning;
};

/// In the order of the tables.
std::span<const TableRow> table_rows();

/// The rows with `word` as their label; case does not count.
std::vector<const TableRow*> rows_with_label(std::string_view word);

/// The same, or where there are none, the rows whose label has its words in a row.
std::vector<const TableRow*> find_rows(std::string_view word);

}  // namespace cls::cli
