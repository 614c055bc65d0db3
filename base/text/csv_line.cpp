// Looks for the end of each cell.
#include "base/text/csv_line.h"

namespace cls::base {
namespace {

// The quotation mark that ends the cell at the start of `rest`; npos without one.
std::size_t closing_quote(std::string_view rest) {
  if (!rest.starts_with('"')) return std::string_view::npos;
  std::size_t at = rest.find('"', 1);
  while (at != std::string_view::npos && at + 1 < rest.size() && rest[at + 1] != ',') {
    at = rest.find('"', at + 1);
  }
  return at;
}

}  // namespace

void split_csv_line(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  if (line.ends_with('\r')) line.remove_suffix(1);
  for (;;) {
    const std::size_t quote = closing_quote(line);
    const bool is_quoted = quote != std::string_view::npos;
    const std::size_t comma = is_quoted ? line.find(',', quote) : line.find(',');
    cells.push_back(is_quoted ? line.substr(1, quote - 1) : line.substr(0, comma));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace cls::base
