// Laying out tables.
#include "base/text/text_table.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/text/csv_cell.h"

namespace cls::base {
namespace {

std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return text;
}

// Bytes that continue a character of UTF-8 have no width.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return right ? blanks + text : text + blanks;
}

void append_line(std::string line, std::string& out) {
  line.resize(line.find_last_not_of(' ') + 1);
  out += line;
  out += '\n';
}

std::string escaped(const std::string& cell, std::string_view special) {
  std::string result;
  for (const char c : cell) {
    if (special.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

void TextTable::add_column(std::string head, Align align) {
  columns_.push_back({std::move(head), align});
}

void TextTable::add_row(std::vector<std::string> cells) {
  assert(cells.size() == columns_.size());
  for (std::string& cell : cells) cell = printable(std::move(cell));
  rows_.push_back(std::move(cells));
}

void TextTable::take_rows(TextTable& other) {
  assert(other.columns_.size() == columns_.size());
  for (auto& row : other.rows_) rows_.push_back(std::move(row));
  other.rows_.clear();
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t width = width_of(columns_[i].head);
    for (const auto& row : rows_) width = std::max(width, width_of(row[i]));
    result.push_back(width);
  }
  return result;
}

std::string TextTable::plain() const {
  const std::vector<std::size_t> width = widths();
  std::string out;
  const auto append = [&](auto cell) {
    std::string line;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (i > 0) line += "  ";
      line += padded(cell(i), width[i], columns_[i].align == Align::kRight);
    }
    append_line(std::move(line), out);
  };
  append([this](std::size_t i) { return columns_[i].head; });
  for (const auto& row : rows_) append([&row](std::size_t i) { return row[i]; });
  return out;
}

std::string TextTable::markdown() const {
  std::string out = "|";
  for (const Column& column : columns_) out += ' ' + escaped(column.head, "|\\") + " |";
  out += "\n|";
  for (const Column& column : columns_) out += column.align == Align::kRight ? "--:|" : "---|";
  out += '\n';
  for (const auto& row : rows_) {
    out += '|';
    for (const std::string& cell : row) out += ' ' + escaped(cell, "|\\*_`<[") + " |";
    out += '\n';
  }
  return out;
}

std::string TextTable::csv() const {
  std::string out;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    out += (i > 0 ? "," : "") + csv_cell(columns_[i].head);
  }
  out += '\n';
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i > 0 ? "," : "") + csv_cell(row[i]);
    out += '\n';
  }
  return out;
}

}  // namespace cls::base
