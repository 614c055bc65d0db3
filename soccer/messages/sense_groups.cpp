// Shared groups of sense_body, fullstate and see_global.
#include "soccer/messages/sense_groups.h"

#include <span>
#include <type_traits>
#include <utility>

namespace cls::soccer {
namespace {

/// A text in messages and its value.
template <typename Value>
using Word = std::pair<std::string_view, Value>;

constexpr Word<ActionMark> kMarks[] = {
    {" t", ActionMark::kTackling}, {" k", ActionMark::kKicked}, {" f", ActionMark::kFoulCharged}};
constexpr Word<Card> kCards[] = {{" y", Card::kYellow}, {" r", Card::kRed}};
constexpr Word<Side> kSides[] = {{"l", Side::kLeft}, {"r", Side::kRight}};
constexpr Word<ViewQuality> kQualities[] = {{"high ", ViewQuality::kHigh},
                                            {"low ", ViewQuality::kLow}};
constexpr Word<ViewWidth> kWidths[] = {
    {"narrow", ViewWidth::kNarrow}, {"normal", ViewWidth::kNormal}, {"wide", ViewWidth::kWide}};

// Consumes the first word that is next; false, with `value` unchanged, if there is none.
template <typename Value>
bool read_word(Scanner& in, std::span<const Word<std::type_identity_t<Value>>> words,
               Value& value) {
  for (const auto& [text, meaning] : words) {
    if (!in.optional(text)) continue;
    value = meaning;
    return true;
  }
  return false;
}

template <typename Value>
void append_word(std::span<const Word<std::type_identity_t<Value>>> words, Value value,
                 TextWriter& out) {
  for (const auto& [text, meaning] : words) {
    if (meaning == value) out.append(text);
  }
}

}  // namespace

bool read_view_mode(Scanner& in, ViewQuality& quality, ViewWidth& width) {
  return (read_word(in, kQualities, quality) || in.fail("high or low")) &&
         (read_word(in, kWidths, width) || in.fail("narrow, normal or wide"));
}

void append_view_mode(ViewQuality quality, ViewWidth width, TextWriter& out) {
  append(out, name(quality), ' ', name(width));
}

bool read_arm(Scanner& in, ArmState& arm) {
  return in.sequence("(arm (movable ", arm.movable_in, ") (expires ", arm.expires_in, ") (target ",
                     arm.target_distance, " ", arm.target_direction, ") (count ", arm.count, "))");
}

void append_arm(const ArmState& arm, TextWriter& out) {
  append(out, "(arm (movable ", arm.movable_in, ") (expires ", arm.expires_in, ") (target ",
         arm.target_distance, ' ', arm.target_direction, ") (count ", arm.count, "))");
}

bool read_side(Scanner& in, Side& side) { return read_word(in, kSides, side) || in.fail("l or r"); }

bool read_motion(Scanner& in, Vec2& position, Vec2& velocity) {
  return in.sequence(position.x, " ", position.y, " ", velocity.x, " ", velocity.y);
}

void append_motion(Vec2 position, Vec2 velocity, TextWriter& out) {
  append(out, position.x, ' ', position.y, ' ', velocity.x, ' ', velocity.y);
}

void read_marks(Scanner& in, ActionMark& mark, Card& card) {
  if (!read_word(in, kMarks, mark)) mark = ActionMark::kNone;
  if (!read_word(in, kCards, card)) card = Card::kNone;
}

void append_marks(ActionMark mark, Card card, TextWriter& out) {
  append_word(kMarks, mark, out);
  append_word(kCards, card, out);
}

}  // namespace cls::soccer
