// Column widths and the output formats of tables.
#include "base/text/table.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/index.h"
#include "base/text/number_text.h"
#include "base/text/printable.h"
#include "base/text/replace_all.h"
#include "base/text/split.h"
#include "base/text/wrap_text.h"
#include "base/text/xml.h"

namespace cls::base {
namespace {

constexpr std::size_t kGap = 2;  // spaces between columns

// Continuation bytes of UTF-8 have no width.
bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

std::size_t width_of(const std::string& text) {
  return index(std::ranges::count_if(text, starts_character));
}

std::string pad(const std::string& text, std::size_t width, bool right) {
  const std::string spaces(width - std::min(width, width_of(text)), ' ');
  return right ? spaces + text : text + spaces;
}

// At most `width` characters, the last three of them dots if it is cut.
std::string cut_to(std::string text, std::size_t width) {
  constexpr std::string_view kEllipsis = "...";
  if (width_of(text) <= width) return text;

  const std::size_t kept = width - std::min(width, kEllipsis.size());
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end) {
    if (starts_character(text[end]) && seen++ == kept) break;
  }

  text.resize(end);
  return text.append(kEllipsis);
}

std::string markdown_cell(std::string cell, std::string_view escaped) {
  std::ranges::replace_if(
      cell, [](char c) { return c == '\n' || c == '\r'; }, ' ');

  std::string result;
  for (const char c : printable(cell)) {
    if (escaped.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string markdown_row(const std::vector<std::string>& cells, std::string_view escaped) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + markdown_cell(cell, escaped) + " |";
  return line + '\n';
}

// True for cells that spreadsheets execute when they open the file. Numbers with a sign are none.
bool is_formula(std::string_view text) {
  constexpr std::string_view kStarts = "=+-@";
  return text.size() > 1 && kStarts.find(text.front()) != std::string_view::npos &&
         !parse_number(text.substr(text.front() == '+' ? 1 : 0));
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += (i > 0 ? "," : "") + csv_cell(cells[i]);
  }
  return line + '\n';
}

}  // namespace

void Table::add_column(std::string heading, Align align) {
  assert(rows_.empty());
  columns_.push_back({std::move(heading), align});
}

void Table::add_columns(const std::vector<std::string_view>& headings, Align align) {
  for (const std::string_view heading : headings) add_column(std::string(heading), align);
}

void Table::add_row(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  rows_.push_back(std::move(cells));
}

void Table::allow_cuts(std::size_t column) { columns_.at(column).may_narrow = true; }

void Table::allow_folds(std::size_t column) {
  columns_.at(column).may_narrow = true;
  columns_.at(column).folds = true;
}

void Table::link_last_row(std::size_t column, std::string address) {
  assert(!rows_.empty() && column < columns_.size());
  links_[{rows_.size() - 1, column}] = std::move(address);
}

void Table::append_rows(Table&& other) {
  assert(other.columns_.size() == columns_.size() && other.links_.empty());
  for (auto& row : other.rows_) rows_.push_back(std::move(row));
  other.rows_.clear();
}

std::vector<std::string> Table::headings() const {
  std::vector<std::string> result;
  for (const Column& column : columns_) result.push_back(column.heading);
  return result;
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t width = width_of(columns_[i].heading);
    for (const auto& row : rows_) width = std::max(width, width_of(row[i]));
    result.push_back(width);
  }
  return result;
}

// The widths that fit into the layout if cuts and folds make it possible, else those without.
std::vector<std::size_t> Table::widths_within(const TextLayout& layout) const {
  constexpr std::size_t kMinCutWidth = 12;
  std::vector<std::size_t> result = widths();
  if (layout.width == 0) return result;

  std::size_t total = layout.indent + kGap * (result.size() - 1);
  for (const std::size_t width : result) total += width;
  for (std::size_t i = 0; i < result.size() && total > layout.width; ++i) {
    if (!columns_[i].may_narrow || result[i] <= kMinCutWidth) continue;
    const std::size_t least = std::max(kMinCutWidth, width_of(columns_[i].heading));
    const std::size_t narrowed = result[i] - std::min(result[i] - least, total - layout.width);
    total -= result[i] - narrowed;
    result[i] = narrowed;
  }

  return total <= layout.width ? result : widths();
}

std::string Table::text_line(const std::vector<std::string>& cells,
                             const std::vector<std::size_t>& columns,
                             const std::vector<std::size_t>& widths, std::size_t indent) const {
  std::string line(indent, ' ');
  for (const std::size_t i : columns) {
    if (i != columns.front()) line.append(kGap, ' ');
    line +=
        pad(cut_to(printable(cells[i]), widths[i]), widths[i], columns_[i].align == Align::kRight);
  }

  line.resize(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

// One line, and those on which folded cells continue.
std::string Table::text_row(std::vector<std::string> cells, const std::vector<std::size_t>& columns,
                            const std::vector<std::size_t>& widths, std::size_t indent) const {
  std::size_t lines = 1;
  for (const std::size_t i : columns) {
    if (!columns_[i].folds || width_of(cells[i]) <= widths[i]) continue;
    cells[i] = wrap_text(cells[i], widths[i]);
    lines = std::max(lines, split(cells[i], '\n').size());
  }
  if (lines == 1) return text_line(cells, columns, widths, indent);

  std::string text;
  for (std::size_t line = 0; line < lines; ++line) {
    std::vector<std::string> parts(cells.size());
    for (const std::size_t i : columns) {
      const std::vector<std::string_view> pieces = split(cells[i], '\n');
      if (line < pieces.size()) parts[i] = pieces[line];
    }
    text += text_line(parts, columns, widths, indent);
  }
  return text;
}

std::string Table::format_text(std::size_t indent) const { return format_text({indent, 0}); }

std::string Table::format_text(const TextLayout& layout) const {
  const std::vector<std::size_t> width = widths_within(layout);
  std::string text;
  for (std::size_t next = 0; next < columns_.size();) {
    std::vector<std::size_t> block;
    std::size_t used = layout.indent;
    const auto add = [&](std::size_t column) {
      used += width[column] + (block.empty() ? 0 : kGap);
      block.push_back(column);
    };

    if (next > 0) {
      text += '\n';
      for (std::size_t key = 0; key < std::min(layout.key_columns, next); ++key) add(key);
    }
    add(next++);
    while (next < columns_.size() &&
           (layout.width == 0 || used + kGap + width[next] <= layout.width)) {
      add(next++);
    }

    text += text_line(headings(), block, width, layout.indent);
    for (const auto& row : rows_) text += text_row(row, block, width, layout.indent);
  }
  return text;
}

std::string Table::format_markdown(const MarkdownStyle& style) const {
  std::string text = markdown_row(headings(), style.escaped_in_headings) + '|';
  for (const Column& column : columns_) {
    text += column.align == Align::kRight ? style.right_delimiter : "---";
    text += '|';
  }
  text += '\n';

  for (std::size_t row = 0; row < rows_.size(); ++row) {
    text += '|';
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string cell = markdown_cell(rows_[row][i], style.escaped_in_cells);
      const auto link = links_.find({row, i});
      text += link == links_.end() ? ' ' + cell + " |" : " [" + cell + "](" + link->second + ") |";
    }
    text += '\n';
  }
  return text;
}

std::string Table::format_csv() const {
  std::string text = csv_row(headings());
  for (const auto& row : rows_) text += csv_row(row);
  return text;
}

std::string Table::format_html(std::string_view caption) const {
  std::string text = "<table>\n";
  if (!caption.empty()) text += "<caption>" + escape_xml(caption) + "</caption>\n";

  const auto class_of = [this](std::size_t column) {
    return columns_[column].align == Align::kLeft ? " class=\"w\"" : "";
  };

  text += "<thead><tr>";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    // A cell without text heads nothing.
    if (columns_[i].heading.empty()) {
      text += "<td></td>";
      continue;
    }
    text += std::string("<th scope=\"col\"") + class_of(i) + '>' + escape_xml(columns_[i].heading) +
            "</th>";
  }

  text += "</tr></thead>\n<tbody>\n";
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    text += "<tr>";
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      std::string cell = escape_xml(rows_[row][i]);
      if (const auto link = links_.find({row, i}); link != links_.end()) {
        cell = "<a href=\"" + escape_xml(link->second) + "\">" + cell + "</a>";
      }
      text += std::string(i == 0 ? "<th scope=\"row\"" : "<td") + class_of(i) + '>' + cell +
              (i == 0 ? "</th>" : "</td>");
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table>\n";
}

std::string csv_cell(std::string_view cell) {
  std::string text = printable(cell);
  if (is_formula(text)) text.insert(text.begin(), '\'');
  if (text.find_first_of(",\"") == std::string::npos) return text;

  replace_all(text, "\"", "\"\"");
  return '"' + text + '"';
}

}  // namespace cls::base
