// Parsing and formatting of sense_body, in the order of the message.
#include "soccer/messages/sense_body.h"

#include <cmath>

#include "base/text/enum_names.h"
#include "base/text/rounded_number.h"
#include "soccer/messages/sense_groups.h"
#include "soccer/messages/values.h"

namespace cls::soccer {
namespace {

// First client versions that receive a field.
constexpr int kFirstWithCollision = 12;
constexpr int kFirstWithCapacity = 13;
constexpr int kFirstWithFoul = 14;
constexpr int kFirstWithFocus = 18;

constexpr auto kCards = base::enum_names<Card>("none", "yellow", "red");

bool read_body(Scanner& in, SenseBody& out) {
  return in.sequence("(sense_body ", out.time, " (view_mode ") &&
         read_view_mode(in, out.quality, out.width) &&
         in.sequence(") (stamina ", out.stamina, " ", out.effort, " ", out.capacity, ") (speed ",
                     out.speed, " ", out.speed_direction, ") (head_angle ", out.head_angle, ")");
}

bool read_counts(Scanner& in, SenseBody& out) {
  CommandCounts& counts = out.counts;
  counts.change_focus = 0;
  if (!in.sequence(" (kick ", counts.kick, ") (dash ", counts.dash, ") (turn ", counts.turn,
                   ") (say ", counts.say, ") (turn_neck ", counts.turn_neck, ") (catch ",
                   counts.catches, ") (move ", counts.move, ") (change_view ", counts.change_view,
                   ")")) {
    return false;
  }

  out.has_focus_point = in.optional(" (change_focus ");
  return !out.has_focus_point || in.sequence(counts.change_focus, ")");
}

bool read_attention(Scanner& in, SenseBody& out) {
  if (!in.literal(" (focus (target ")) return false;

  out.attention_side = Side::kNeutral;
  out.attention_unum = 0;
  if (!in.optional("none") && !(read_side(in, out.attention_side) && in.literal(" ") &&
                                in.integer(out.attention_unum, 1, kPlayersPerTeam))) {
    return false;
  }

  return in.sequence(") (count ", out.attention_count, "))");
}

bool read_collision(Scanner& in, SenseBody& out) {
  if (!in.literal(" (collision ")) return false;
  out.collided_with_ball = out.collided_with_player = out.collided_with_post = false;

  if (in.optional("none)")) return true;

  out.collided_with_ball = in.optional("(ball)");
  if (out.collided_with_ball) in.optional(" ");
  out.collided_with_player = in.optional("(player)");
  if (out.collided_with_player) in.optional(" ");
  out.collided_with_post = in.optional("(post)");

  if (!out.collided_with_ball && !out.collided_with_player && !out.collided_with_post) {
    return in.fail("none, (ball), (player) or (post)");
  }
  return in.literal(")");
}

bool read_foul(Scanner& in, SenseBody& out) {
  if (!in.sequence(" (foul (charged ", out.foul_charged, ") (card ")) return false;
  for (const Card card : {Card::kNone, Card::kYellow, Card::kRed}) {
    if (!in.optional(kCards.name(card))) continue;
    out.card = card;
    return in.literal("))");
  }
  return in.fail("none, yellow or red");
}

bool read_focus_point(Scanner& in, SenseBody& out) {
  out.focus_distance = out.focus_direction = 0.0;
  if (!out.has_focus_point) return true;
  return in.sequence(" (focus_point ", out.focus_distance, " ", out.focus_direction, ")");
}

void append_counts(const CommandCounts& counts, int version, TextWriter& out) {
  append(out, " (kick ", counts.kick, ") (dash ", counts.dash, ") (turn ", counts.turn, ") (say ",
         counts.say, ") (turn_neck ", counts.turn_neck, ") (catch ", counts.catches, ") (move ",
         counts.move, ") (change_view ", counts.change_view);
  if (version >= kFirstWithFocus) append(out, ") (change_focus ", counts.change_focus);
  out.append(") ");
}

void append_attention(const SenseBody& sense, TextWriter& out) {
  out.append(" (focus (target ");

  if (sense.attention_side == Side::kNeutral) {
    out.append("none");
  } else {
    append(out, letter(sense.attention_side), ' ', sense.attention_unum);
  }
  append(out, ") (count ", sense.attention_count);
}

void append_collision(const SenseBody& sense, TextWriter& out) {
  out.append(" (collision ");
  std::string_view separator;

  const auto add = [&](bool collided, std::string_view text) {
    if (!collided) return;
    append(out, separator, text);
    separator = " ";
  };

  add(sense.collided_with_ball, "(ball)");
  add(sense.collided_with_player, "(player)");
  add(sense.collided_with_post, "(post)");
  out.append(separator.empty() ? "none)" : ")");
}

// False, with the numbers from there on unchanged, if one is not finite.
template <typename... Numbers>
bool round_to_text(Numbers&... numbers) {
  return ((std::isfinite(numbers) && (numbers = base::rounded_to_text(numbers), true)) && ...);
}

}  // namespace

bool make_as_sent(SenseBody& sense, int version) {
  // A player that points infinitely far away has a direction that is not read.
  const bool reads_arm = sense.arm.target_direction >= -kMaxInteger;
  if (version < kFirstWithFoul || !reads_arm) return false;

  if (sense.attention_side == Side::kNeutral) sense.attention_unum = 0;
  sense.has_focus_point = version >= kFirstWithFocus;
  if (!sense.has_focus_point) {
    sense.counts.change_focus = 0;
    sense.focus_distance = sense.focus_direction = 0.0;
  }
  return round_to_text(sense.stamina, sense.effort, sense.capacity, sense.speed,
                       sense.arm.target_distance, sense.focus_distance, sense.focus_direction);
}

base::Result<void> parse(std::string_view message, SenseBody& out) {
  Scanner in(message);
  const bool whole = read_body(in, out) && read_counts(in, out) && in.literal(" ") &&
                     read_arm(in, out.arm) && read_attention(in, out) &&
                     in.sequence(" (tackle (expires ", out.tackle_expires_in, ") (count ",
                                 out.tackle_count, "))") &&
                     read_collision(in, out) && read_foul(in, out) && read_focus_point(in, out) &&
                     in.literal(")");
  return in.finish(whole, "sense_body");
}

void format(const SenseBody& sense, int version, std::string& text) {
  TextWriter out(text);
  append(out, "(sense_body ", sense.time, " (view_mode ");
  append_view_mode(sense.quality, sense.width, out);
  append(out, ") (stamina ", sense.stamina, ' ', sense.effort);
  if (version >= kFirstWithCapacity) append(out, ' ', sense.capacity);
  append(out, ") (speed ", sense.speed, ' ', sense.speed_direction, ") (head_angle ",
         sense.head_angle, ')');

  append_counts(sense.counts, version, out);
  append_arm(sense.arm, out);
  append_attention(sense, out);

  append(out, ")) (tackle (expires ", sense.tackle_expires_in, ") (count ", sense.tackle_count,
         "))");

  if (version >= kFirstWithCollision) append_collision(sense, out);
  if (version >= kFirstWithFoul) {
    append(out, " (foul (charged ", sense.foul_charged, ") (card ", kCards.name(sense.card), "))");
  }
  if (version >= kFirstWithFocus) {
    append(out, " (focus_point ", sense.focus_distance, ' ', sense.focus_direction, ')');
  }

  out.push_back(')');
}

}  // namespace cls::soccer
