// A table of text cells, formatted as text, Markdown, CSV or HTML.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cls::base {

/// Markdown dialect: the characters that are escaped with a backslash, and the delimiter of
/// right-aligned columns.
struct MarkdownStyle {
  std::string_view escaped_in_headings = "|\\<";
  std::string_view escaped_in_cells = "|\\*_`<[";
  std::string_view right_delimiter = "--:";
};

/// How a table is printed as text.
struct TextLayout {
  std::size_t indent = 0;
  std::size_t width = 0;        ///< of a line; 0: unlimited
  std::size_t key_columns = 1;  ///< leading columns that every block repeats
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
  /// Where a table as text would be too wide, cells of `column` are cut and end in "...".
  void allow_cuts(std::size_t column);
  /// Where a table as text would be too wide, cells of `column` continue on further lines.
  void allow_folds(std::size_t column);
  /// Makes a cell of the last row a link in Markdown and HTML. `address` is a URL.
  void link_last_row(std::size_t column, std::string address);
  /// Moves the rows of `other`, which has the same columns and no links, to the end of this table.
  void append_rows(Table&& other);

  /// True for a table without columns.
  bool empty() const { return columns_.empty(); }

  /// Aligned columns, two spaces apart, each line indented by `indent` spaces. What
  /// may not be printed (printable.h) becomes '?', here and in the other formats.
  std::string format_text(std::size_t indent = 0) const;
  /// Formats the table within a width: a table that is wider is cut where allowed, then split into
  /// blocks of columns, one below the other. A single column may still be wider.
  std::string format_text(const TextLayout& layout) const;
  /// White space in cells becomes a space.
  std::string format_markdown(const MarkdownStyle& style = {}) const;
  /// RFC 4180, with line feeds; cells are quoted only where necessary (csv_cell).
  std::string format_csv() const;
  /// A <table> element with `caption`, if there is one; cells of left-aligned columns have the
  /// class "w", the first column heads the rows.
  std::string format_html(std::string_view caption = "") const;

 private:
  struct Column {
    std::string heading;
    Align align;
    bool may_narrow = false;
    bool folds = false;  ///< instead of being cut
  };

  std::vector<std::size_t> widths() const;
  std::vector<std::size_t> widths_within(const TextLayout& layout) const;
  std::string text_line(const std::vector<std::string>& cells,
                        const std::vector<std::size_t>& columns,
                        const std::vector<std::size_t>& widths, std::size_t indent) const;
  std::string text_row(std::vector<std::string> cells, const std::vector<std::size_t>& columns,
                       const std::vector<std::size_t>& widths, std::size_t indent) const;
  std::vector<std::string> headings() const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
  std::map<std::pair<std::size_t, std::size_t>, std::string> links_;  ///< by row and column
};

/// `cell` as a CSV cell (RFC 4180): quoted, with doubled quotes, if it holds a comma or quote. One
/// that spreadsheets would take for a formula gets an apostrophe in front.
std::string csv_cell(std::string_view cell);

}  // namespace cls::base
