// Tables with columns, as plain text, Markdown or CSV.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cls::base {

/// Rows of cells under a head. Widths count characters of UTF-8, not bytes; control characters in
/// cells are shown as '?'.
class TextTable {
 public:
  enum class Align : unsigned char { kLeft, kRight };

  void add_column(std::string head, Align align = Align::kLeft);
  /// As many cells as there are columns.
  void add_row(std::vector<std::string> cells);
  /// Moves the rows of a table with the same columns to the end of this one.
  void take_rows(TextTable& other);

  std::string plain() const;
  std::string markdown() const;
  /// RFC 4180 with line feeds; quotes where they are needed.
  std::string csv() const;

 private:
  struct Column {
    std::string head;
    Align align;
  };
  std::vector<std::size_t> widths() const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace cls::base
