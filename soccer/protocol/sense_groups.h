// Groups that several sense messages have in common, read and written once.
#pragma once

#include <string>

#include "soccer/geometry.h"
#include "soccer/protocol/scanner.h"
#include "soccer/protocol/see.h"
#include "soccer/protocol/sense_body.h"

namespace cls::soccer {

/// "high narrow" and so on.
bool read_view_mode(Scanner& in, ViewQuality& quality, ViewWidth& width);
void append_view_mode(ViewQuality quality, ViewWidth width, std::string& out);

/// "(arm (movable 4) (expires 19) (target 10 20) (count 1))"
bool read_arm(Scanner& in, ArmState& arm);
void append_arm(const ArmState& arm, std::string& out);

/// "l" or "r"
bool read_side(Scanner& in, Side& side);

/// "X Y VX VY"
bool read_motion(Scanner& in, Vec2& position, Vec2& velocity);
void append_motion(Vec2 position, Vec2 velocity, std::string& out);

/// The optional letters at the end of a player: " t", " k" or " f", then " y" or " r".
void read_marks(Scanner& in, ActionMark& mark, Card& card);
void append_marks(ActionMark mark, Card card, std::string& out);

/// Appends `before`, then the number.
inline void append(std::string& out, std::string_view before, int value) {
  out.append(before);
  append_int(value, out);
}
inline void append(std::string& out, std::string_view before, double value) {
  out.append(before);
  append_g(value, out);
}

}  // namespace cls::soccer
