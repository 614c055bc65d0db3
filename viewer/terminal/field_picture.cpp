// Two by four dots of braille in each character.
#include "viewer/terminal/field_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/index.h"
#include "soccer/pitch.h"
#include "soccer/side.h"

namespace cls::viewer {
namespace {

using soccer::Vec2;

constexpr int kDotColumns = 2;
constexpr int kDotRows = 4;
constexpr double kGoalHalfWidth = 7.01;
constexpr double kShownHalfLength = soccer::kHalfLength + soccer::kGoalDepth;
constexpr double kShownHalfWidth = soccer::kHalfWidth + 1.0;
constexpr double kTau = 6.283185307179586;

// U+2800 plus the bits of the dots.
std::string braille(unsigned bits) {
  const unsigned code = 0x2800 + bits;
  return {static_cast<char>(0xe0 | (code >> 12)), static_cast<char>(0x80 | ((code >> 6) & 0x3f)),
          static_cast<char>(0x80 | (code & 0x3f))};
}

class Dots {
 public:
  Dots(int columns, int rows)
      : columns_(columns), rows_(rows), bits_(base::index(columns) * base::index(rows), 0) {
    const double across = kDotColumns * columns_ / (2 * kShownHalfLength);
    const double down = kDotRows * rows_ / (2 * kShownHalfWidth);
    scale_ = std::min(across, down);
  }

  /// Dots from the left and from the top.
  double x_of(double x) const { return kDotColumns * columns_ / 2.0 + x * scale_; }
  double y_of(double y) const { return kDotRows * rows_ / 2.0 + y * scale_; }
  int column_of(double x) const { return static_cast<int>(std::floor(x_of(x) / kDotColumns)); }
  int row_of(double y) const { return static_cast<int>(std::floor(y_of(y) / kDotRows)); }

  void line(Vec2 from, Vec2 to) {
    const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) * scale_;
    const int steps = std::max(1, 2 * static_cast<int>(std::ceil(length)));
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      dot({from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share});
    }
  }

  void rectangle(double x, double y, double half_height) {
    line({x, -half_height}, {x, half_height});
    line({x, -half_height}, {y, -half_height});
    line({x, half_height}, {y, half_height});
  }

  void circle(double radius) {
    const int steps = std::max(8, static_cast<int>(kTau * radius * scale_));
    for (int i = 0; i < steps; ++i) {
      const double angle = kTau * i / steps;
      dot({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }

  void put(int top, Screen& screen) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const unsigned bits = bits_[index(row, column)];
        if (bits != 0) screen.put(top + row, column, {braille(bits), Ink::kDim, false});
      }
    }
  }

 private:
  std::size_t index(int row, int column) const {
    return base::index(row) * base::index(columns_) + base::index(column);
  }

  void dot(Vec2 at) {
    const int x = std::clamp(static_cast<int>(x_of(at.x)), 0, kDotColumns * columns_ - 1);
    const int y = std::clamp(static_cast<int>(y_of(at.y)), 0, kDotRows * rows_ - 1);

    constexpr std::array<std::array<unsigned, kDotColumns>, kDotRows> kBits = {
        {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}}};
    bits_[index(y / kDotRows, x / kDotColumns)] |=
        kBits[base::index(y % kDotRows)][base::index(x % kDotColumns)];
  }

  int columns_;
  int rows_;
  double scale_ = 1.0;
  std::vector<unsigned> bits_;
};

void draw_lines(Dots& dots) {
  using namespace soccer;
  for (const double side : {-1.0, 1.0}) {
    const double end = side * kHalfLength;
    dots.line({-kHalfLength, side * kHalfWidth}, {kHalfLength, side * kHalfWidth});
    dots.line({end, -kHalfWidth}, {end, kHalfWidth});
    dots.rectangle(end - side * kPenaltyAreaLength, end, kPenaltyAreaWidth / 2);
    dots.rectangle(end - side * kGoalAreaLength, end, kGoalAreaWidth / 2);
    dots.rectangle(end + side * kGoalDepth, end, kGoalHalfWidth);
  }

  dots.line({0, -kHalfWidth}, {0, kHalfWidth});
  dots.circle(kCenterCircleRadius);
}

Cell player_cell(std::size_t slot, bool letters) {
  const bool left = slot < soccer::kPlayersPerTeam;
  const std::size_t number = slot % soccer::kPlayersPerTeam;
  std::string text(1, "123456789AB"[number]);
  if (letters) text = std::string(1, static_cast<char>((left ? 'A' : 'a') + number));
  return {text, left ? Ink::kLeft : Ink::kRight, false};
}

}  // namespace

void draw_field(const gamelog::Frame& frame, const FieldArea& area, Screen& screen) {
  Dots dots(screen.columns(), std::max(1, area.rows));
  draw_lines(dots);
  dots.put(area.top, screen);

  const int ball_row = dots.row_of(frame.ball_position.y);
  const int ball_column = dots.column_of(frame.ball_position.x);
  const auto is_inside = [&](int row) { return row >= 0 && row < area.rows; };
  if (is_inside(ball_row)) {
    screen.put(area.top + ball_row, ball_column, {"●", Ink::kBold, false});
  }

  for (std::size_t slot = 0; slot < frame.players.size(); ++slot) {
    const gamelog::PlayerFrame& player = frame.players[slot];
    const int row = dots.row_of(player.position.y);
    if ((player.state & gamelog::kStateEnabled) == 0 || !is_inside(row)) continue;

    Cell cell = player_cell(slot, area.letters);
    const int column = dots.column_of(player.position.x);
    // A player on the ball hides it; the cell is reversed instead.
    cell.reverse = row == ball_row && column == ball_column;
    screen.put(area.top + row, column, std::move(cell));
  }
}

}  // namespace cls::viewer
