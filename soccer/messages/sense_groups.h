// Groups of fields that several sensor messages share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/protocol/scanner.h"
#include "soccer/protocol/text_writer.h"

namespace cls::soccer {

/// Reads the list at the end of a message, each item after a space; `too_many` is the error of more
/// than `most` items.
template <typename Item, typename ReadItem>
bool read_items(Scanner& in, std::vector<Item>& items, std::size_t most, std::string_view too_many,
                ReadItem read_item) {
  while (in.peek() == ' ') {
    if (items.size() == most) return in.fail(too_many);
    if (!read_item(items.emplace_back())) return false;
  }
  return in.literal(")");
}

/// "high narrow" and so on.
bool read_view_mode(Scanner& in, ViewQuality& quality, ViewWidth& width);
void append_view_mode(ViewQuality quality, ViewWidth width, TextWriter& out);

/// "(arm (movable 4) (expires 19) (target 10 20) (count 1))"
bool read_arm(Scanner& in, ArmState& arm);
void append_arm(const ArmState& arm, TextWriter& out);

/// "l" or "r"
bool read_side(Scanner& in, Side& side);

/// "X Y VX VY"
bool read_motion(Scanner& in, Vec2& position, Vec2& velocity);
void append_motion(Vec2 position, Vec2 velocity, TextWriter& out);

/// The optional letters at the end of a player: " t", " k" or " f", then " y" or " r".
void read_marks(Scanner& in, ActionMark& mark, Card& card);
void append_marks(ActionMark mark, Card card, TextWriter& out);

}  // namespace cls::soccer
