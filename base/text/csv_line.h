// Cells of a line of comma-separated values.
#pragma once

#include <string_view>
#include <vector>

namespace cls::base {

/// Replaces `cells` by the cells of `line`, which views into it; a carriage return at the end is no
/// part of the last one. A cell that begins with a quotation mark ends at the next one before a
/// comma or the end of the line, and is returned without both.
void split_csv_line(std::string_view line, std::vector<std::string_view>& cells);

}  // namespace cls::base
