// Shared groups of sense_body, fullstate and see_global.
#include "soccer/messages/sense_groups.h"

namespace cls::soccer {

bool read_view_mode(Scanner& in, ViewQuality& quality, ViewWidth& width) {
  if (in.optional("high ")) {
    quality = ViewQuality::kHigh;
  } else if (in.optional("low ")) {
    quality = ViewQuality::kLow;
  } else {
    return in.fail("high or low");
  }

  for (const ViewWidth candidate : {ViewWidth::kNarrow, ViewWidth::kNormal, ViewWidth::kWide}) {
    if (!in.optional(name(candidate))) continue;
    width = candidate;
    return true;
  }

  return in.fail("narrow, normal or wide");
}

void append_view_mode(ViewQuality quality, ViewWidth width, TextWriter& out) {
  out.append(name(quality));
  out.push_back(' ');
  out.append(name(width));
}

bool read_arm(Scanner& in, ArmState& arm) {
  return in.literal("(arm (movable ") && in.integer(arm.movable_in) && in.literal(") (expires ") &&
         in.integer(arm.expires_in) && in.literal(") (target ") && in.number(arm.target_distance) &&
         in.literal(" ") && in.integer(arm.target_direction) && in.literal(") (count ") &&
         in.integer(arm.count) && in.literal("))");
}

void append_arm(const ArmState& arm, TextWriter& out) {
  append(out, "(arm (movable ", arm.movable_in);
  append(out, ") (expires ", arm.expires_in);
  append(out, ") (target ", arm.target_distance);
  append(out, " ", arm.target_direction);
  append(out, ") (count ", arm.count);
  out.append("))");
}

bool read_side(Scanner& in, Side& side) {
  if (in.optional("l")) {
    side = Side::kLeft;
  } else if (in.optional("r")) {
    side = Side::kRight;
  } else {
    return in.fail("l or r");
  }
  return true;
}

bool read_motion(Scanner& in, Vec2& position, Vec2& velocity) {
  return in.number(position.x) && in.literal(" ") && in.number(position.y) && in.literal(" ") &&
         in.number(velocity.x) && in.literal(" ") && in.number(velocity.y);
}

void append_motion(Vec2 position, Vec2 velocity, TextWriter& out) {
  out.append_number(position.x);
  append(out, " ", position.y);
  append(out, " ", velocity.x);
  append(out, " ", velocity.y);
}

void read_marks(Scanner& in, ActionMark& mark, Card& card) {
  if (in.optional(" t")) {
    mark = ActionMark::kTackling;
  } else if (in.optional(" k")) {
    mark = ActionMark::kKicked;
  } else if (in.optional(" f")) {
    mark = ActionMark::kFoulCharged;
  } else {
    mark = ActionMark::kNone;
  }

  if (in.optional(" y")) {
    card = Card::kYellow;
  } else if (in.optional(" r")) {
    card = Card::kRed;
  } else {
    card = Card::kNone;
  }
}

void append_marks(ActionMark mark, Card card, TextWriter& out) {
  if (mark == ActionMark::kTackling) out.append(" t");
  if (mark == ActionMark::kKicked) out.append(" k");
  if (mark == ActionMark::kFoulCharged) out.append(" f");

  if (card == Card::kYellow) out.append(" y");
  if (card == Card::kRed) out.append(" r");
}

}  // namespace cls::soccer
