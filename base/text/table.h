// A table of text cells, formatted as text, Markdown, CSV or HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cls::base {

/// Markdown dialect: the characters that are escaped with a backslash, and the delimiter of
/// right-aligned columns.
struct MarkdownStyle {
  std::string_view escaped_in_headings = "|\\";
  std::string_view escaped_in_cells = "|\\*_`<[";
  std::string_view right_delimiter = "--:";
};

/// Rows of cells below a row of column headings. Column widths count UTF-8 characters, not bytes.
class Table {
 public:
  enum class Align : unsigned char { kLeft, kRight };

  /// Columns are added before the first row.
  void add_column(std::string heading, Align align = Align::kLeft);
  void add_columns(const std::vector<std::string_view>& headings, Align align = Align::kLeft);
  /// `cells` holds one cell per column.
  void add_row(std::vector<std::string> cells);
  /// Moves the rows of `other`, which has the same columns, to the end of this table.
  void append_rows(Table&& other);

  /// True for a table without columns.
  bool empty() const { return columns_.empty(); }

  /// Aligned columns, two spaces apart, each line indented by `indent` spaces. Control characters
  /// become '?'.
  std::string format_text(std::size_t indent = 0) const;
  /// White space in cells becomes a space, other control characters become '?'.
  std::string format_markdown(const MarkdownStyle& style = {}) const;
  /// RFC 4180, with line feeds; cells are quoted only where necessary. Control characters become
  /// '?'.
  std::string format_csv() const;
  /// A <table> element; cells of left-aligned columns have the class "w".
  std::string format_html() const;

 private:
  struct Column {
    std::string heading;
    Align align;
  };
  std::vector<std::size_t> widths() const;
  std::vector<std::string> headings() const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// `text` as a CSV cell (RFC 4180): quoted, with doubled quotes, if it holds a comma, quote or line
/// end.
std::string csv_cell(std::string_view text);

}  // namespace cls::base
