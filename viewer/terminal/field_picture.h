// The field in characters: lines of braille dots, players as numbers.
#pragma once

#include "gamelog/record/frame.h"
#include "viewer/terminal/screen.h"

namespace cls::viewer {

struct FieldArea {
  int top = 0;
  int rows = 0;
  /// Players as letters, A to K on the left and a to k on the right; otherwise as 1 to 9, A and B
  /// in the colors of their teams.
  bool letters = false;
};

/// Draws the field into all columns of these rows. A dot of braille is square, so the pitch keeps
/// its proportions.
void draw_field(const gamelog::Frame& frame, const FieldArea& area, Screen& screen);

}  // namespace cls::viewer
