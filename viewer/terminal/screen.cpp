// Escape sequences of ECMA-48 that every terminal knows.
#include "viewer/terminal/screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/index.h"
#include "base/text/enum_names.h"

namespace cls::viewer {
namespace {

// Terminals that know the sequence show a picture as a whole, others ignore it.
constexpr std::string_view kBeginUpdate = "\x1b[?2026h";
constexpr std::string_view kEndUpdate = "\x1b[?2026l";

constexpr auto kColorCodes = base::enum_names<Ink>("", ";2", ";1", ";1;38;5;75", ";1;38;5;215");
constexpr auto kPlainCodes = base::enum_names<Ink>("", ";2", ";1", ";1", ";1");

std::string style(const Cell& cell, bool color) {
  return fmt::format("\x1b[0{}{}m", (color ? kColorCodes : kPlainCodes).name(cell.ink),
                     cell.reverse ? ";7" : "");
}

}  // namespace

Screen::Screen(int columns, int rows) : columns_(std::max(1, columns)), rows_(std::max(1, rows)) {
  cells_.resize(base::index(columns_) * base::index(rows_));
}

std::size_t Screen::index(int row, int column) const {
  return base::index(row) * base::index(columns_) + base::index(column);
}

const Cell& Screen::at(int row, int column) const { return cells_[index(row, column)]; }

void Screen::put(int row, int column, Cell cell) {
  if (row < 0 || row >= rows_ || column < 0 || column >= columns_) return;
  cells_[index(row, column)] = std::move(cell);
}

void Screen::write(int row, int column, std::string_view text, Ink ink) {
  for (const char c : text) {
    const bool printable = c >= ' ' && c <= '~';
    put(row, column++, {std::string(1, printable ? c : '?'), ink, false});
  }
}

std::string Screen::update(const Screen* before, bool color) const {
  std::string out(kBeginUpdate);
  std::string shown_style;
  for (int row = 0; row < rows_; ++row) {
    bool adjacent = false;
    for (int column = 0; column < columns_; ++column) {
      const Cell& cell = at(row, column);
      if (before != nullptr && before->at(row, column) == cell) {
        adjacent = false;
        continue;
      }

      if (!adjacent) out += fmt::format("\x1b[{};{}H", row + 1, column + 1);
      adjacent = true;
      if (const std::string wanted = style(cell, color); wanted != shown_style) {
        out += wanted;
        shown_style = wanted;
      }
      out += cell.text;
    }
  }

  out += "\x1b[0m";
  return out.append(kEndUpdate);
}

std::string Screen::text() const {
  std::string all;
  for (int row = 0; row < rows_; ++row) {
    std::string line;
    for (int column = 0; column < columns_; ++column) line += at(row, column).text;
    line.erase(line.find_last_not_of(' ') + 1);
    all += line + "\n";
  }
  return all;
}

}  // namespace cls::viewer
