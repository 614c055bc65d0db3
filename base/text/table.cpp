// Column widths and the four output formats of tables.
#include "base/text/table.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/text/xml.h"

namespace cls::base {
namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

std::string without_control(std::string text) {
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

// Continuation bytes of UTF-8 have no width.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string pad(const std::string& text, std::size_t width, bool right) {
  const std::string spaces(width - std::min(width, width_of(text)), ' ');
  return right ? spaces + text : text + spaces;
}

std::string markdown_cell(const std::string& cell, std::string_view escaped) {
  std::string result;
  for (const char c : cell) {
    if (escaped.find(c) != std::string_view::npos) result += '\\';
    const bool space = c == '\n' || c == '\t' || c == '\r';
    result += space ? ' ' : is_control(c) ? '?' : c;
  }
  return result;
}

std::string markdown_row(const std::vector<std::string>& cells, std::string_view escaped) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + markdown_cell(cell, escaped) + " |";
  return line + '\n';
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += (i > 0 ? "," : "") + csv_cell(without_control(cells[i]));
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

void Table::append_rows(Table&& other) {
  assert(other.columns_.size() == columns_.size());
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

std::string Table::format_text(std::size_t indent) const {
  const std::vector<std::size_t> width = widths();
  std::string text;
  const auto append = [&](const std::vector<std::string>& cells) {
    std::string line(indent, ' ');
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (i > 0) line += "  ";
      line += pad(without_control(cells[i]), width[i], columns_[i].align == Align::kRight);
    }
    line.resize(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  };
  append(headings());
  for (const auto& row : rows_) append(row);
  return text;
}

std::string Table::format_markdown(const MarkdownStyle& style) const {
  std::string text = markdown_row(headings(), style.escaped_in_headings) + '|';
  for (const Column& column : columns_) {
    text += column.align == Align::kRight ? style.right_delimiter : "---";
    text += '|';
  }
  text += '\n';
  for (const auto& row : rows_) text += markdown_row(row, style.escaped_in_cells);
  return text;
}

std::string Table::format_csv() const {
  std::string text = csv_row(headings());
  for (const auto& row : rows_) text += csv_row(row);
  return text;
}

std::string Table::format_html() const {
  std::string text = "<table>\n";
  const auto append = [&](const std::vector<std::string>& cells, const std::string& tag) {
    text += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const char* attribute = columns_[i].align == Align::kLeft ? " class=\"w\"" : "";
      text += '<' + tag + attribute + '>' + escape_xml(cells[i]) + "</" + tag + '>';
    }
    text += "</tr>\n";
  };
  append(headings(), "th");
  for (const auto& row : rows_) append(row, "td");
  return text + "</table>\n";
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace cls::base
