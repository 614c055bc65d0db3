// A picture of characters, and what a terminal needs to show it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cls::viewer {

enum class Ink : std::uint8_t { kPlain, kDim, kBold, kLeft, kRight };

struct Cell {
  std::string text = " ";  ///< one character of one column, UTF-8
  Ink ink = Ink::kPlain;
  bool reverse = false;

  friend bool operator==(const Cell&, const Cell&) = default;
};

class Screen {
 public:
  Screen(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const Cell& at(int row, int column) const;

  /// Outside of the screen nothing happens.
  void put(int row, int column, Cell cell);
  /// ASCII text, cut at the edge. Other bytes become '?': names may have any, and escape sequences
  /// must not reach the terminal.
  void write(int row, int column, std::string_view text, Ink ink = Ink::kPlain);

  /// Escape sequences that turn `before` (of the same size) into this screen; all of it if null.
  /// Without color, inks become bold and dim only.
  std::string update(const Screen* before, bool color) const;

  friend bool operator==(const Screen&, const Screen&) = default;

  /// The rows as text, without inks and trailing spaces.
  std::string text() const;

 private:
  std::size_t index(int row, int column) const;

  int columns_;
  int rows_;
  std::vector<Cell> cells_;
};

}  // namespace cls::viewer
