// Parsing and formatting of sense_body, in the order of the message.
#include "soccer/messages/sense_body.h"

#include "soccer/messages/sense_groups.h"

namespace cls::soccer {
namespace {

// First client versions that receive a field.
constexpr int kFirstWithCollision = 12;
constexpr int kFirstWithCapacity = 13;
constexpr int kFirstWithFoul = 14;
constexpr int kFirstWithFocus = 18;

bool read_body(Scanner& in, SenseBody& out) {
  return in.literal("(sense_body ") && in.integer(out.time) && in.literal(" (view_mode ") &&
         read_view_mode(in, out.quality, out.width) && in.literal(") (stamina ") &&
         in.number(out.stamina) && in.literal(" ") && in.number(out.effort) && in.literal(" ") &&
         in.number(out.capacity) && in.literal(") (speed ") && in.number(out.speed) &&
         in.literal(" ") && in.integer(out.speed_direction) && in.literal(") (head_angle ") &&
         in.integer(out.head_angle) && in.literal(")");
}

bool read_counts(Scanner& in, SenseBody& out) {
  CommandCounts& counts = out.counts;
  counts.change_focus = 0;
  if (!(in.literal(" (kick ") && in.integer(counts.kick) && in.literal(") (dash ") &&
        in.integer(counts.dash) && in.literal(") (turn ") && in.integer(counts.turn) &&
        in.literal(") (say ") && in.integer(counts.say) && in.literal(") (turn_neck ") &&
        in.integer(counts.turn_neck) && in.literal(") (catch ") && in.integer(counts.catches) &&
        in.literal(") (move ") && in.integer(counts.move) && in.literal(") (change_view ") &&
        in.integer(counts.change_view) && in.literal(")"))) {
    return false;
  }

  out.has_focus_point = in.optional(" (change_focus ");
  return !out.has_focus_point || (in.integer(counts.change_focus) && in.literal(")"));
}

bool read_attention(Scanner& in, SenseBody& out) {
  if (!in.literal(" (focus (target ")) return false;

  out.attention_side = Side::kNeutral;
  out.attention_unum = 0;
  if (!in.optional("none") && !(read_side(in, out.attention_side) && in.literal(" ") &&
                                in.integer(out.attention_unum, 1, kPlayersPerTeam))) {
    return false;
  }

  return in.literal(") (count ") && in.integer(out.attention_count) && in.literal("))");
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
  if (!(in.literal(" (foul (charged ") && in.integer(out.foul_charged) && in.literal(") (card "))) {
    return false;
  }

  if (in.optional("none")) {
    out.card = Card::kNone;
  } else if (in.optional("yellow")) {
    out.card = Card::kYellow;
  } else if (in.optional("red")) {
    out.card = Card::kRed;
  } else {
    return in.fail("none, yellow or red");
  }

  return in.literal("))");
}

bool read_focus_point(Scanner& in, SenseBody& out) {
  out.focus_distance = out.focus_direction = 0.0;
  if (!out.has_focus_point) return true;
  return in.literal(" (focus_point ") && in.number(out.focus_distance) && in.literal(" ") &&
         in.number(out.focus_direction) && in.literal(")");
}

void append_counts(const CommandCounts& counts, int version, TextWriter& out) {
  append(out, " (kick ", counts.kick);
  append(out, ") (dash ", counts.dash);
  append(out, ") (turn ", counts.turn);
  append(out, ") (say ", counts.say);
  append(out, ") (turn_neck ", counts.turn_neck);
  append(out, ") (catch ", counts.catches);
  append(out, ") (move ", counts.move);
  append(out, ") (change_view ", counts.change_view);

  if (version >= kFirstWithFocus) append(out, ") (change_focus ", counts.change_focus);
  out.append(") ");
}

void append_attention(const SenseBody& sense, TextWriter& out) {
  out.append(" (focus (target ");

  if (sense.attention_side == Side::kNeutral) {
    out.append("none");
  } else {
    out.push_back(letter(sense.attention_side));
    append(out, " ", sense.attention_unum);
  }
  append(out, ") (count ", sense.attention_count);
}

void append_collision(const SenseBody& sense, TextWriter& out) {
  out.append(" (collision ");
  std::string_view separator;

  const auto add = [&](bool collided, std::string_view text) {
    if (!collided) return;
    out.append(separator);
    out.append(text);
    separator = " ";
  };

  add(sense.collided_with_ball, "(ball)");
  add(sense.collided_with_player, "(player)");
  add(sense.collided_with_post, "(post)");
  out.append(separator.empty() ? "none)" : ")");
}

std::string_view name(Card card) {
  return card == Card::kNone ? "none" : card == Card::kYellow ? "yellow" : "red";
}

void append_foul(const SenseBody& sense, TextWriter& out) {
  append(out, " (foul (charged ", sense.foul_charged);
  out.append(") (card ");
  out.append(name(sense.card));
  out.append("))");
}

}  // namespace

base::Result<void> parse(std::string_view message, SenseBody& out) {
  Scanner in(message);
  if (read_body(in, out) && read_counts(in, out) && in.literal(" ") && read_arm(in, out.arm) &&
      read_attention(in, out) && in.literal(" (tackle (expires ") &&
      in.integer(out.tackle_expires_in) && in.literal(") (count ") &&
      in.integer(out.tackle_count) && in.literal("))") && read_collision(in, out) &&
      read_foul(in, out) && read_focus_point(in, out) && in.literal(")") && in.end()) {
    return {};
  }
  return in.error("sense_body");
}

void format(const SenseBody& sense, int version, std::string& text) {
  TextWriter out(text);
  append(out, "(sense_body ", sense.time);

  out.append(" (view_mode ");
  append_view_mode(sense.quality, sense.width, out);
  append(out, ") (stamina ", sense.stamina);
  append(out, " ", sense.effort);
  if (version >= kFirstWithCapacity) append(out, " ", sense.capacity);

  append(out, ") (speed ", sense.speed);
  append(out, " ", sense.speed_direction);
  append(out, ") (head_angle ", sense.head_angle);
  out.push_back(')');

  append_counts(sense.counts, version, out);
  append_arm(sense.arm, out);
  append_attention(sense, out);

  append(out, ")) (tackle (expires ", sense.tackle_expires_in);
  append(out, ") (count ", sense.tackle_count);
  out.append("))");

  if (version >= kFirstWithCollision) append_collision(sense, out);
  if (version >= kFirstWithFoul) append_foul(sense, out);
  if (version >= kFirstWithFocus) {
    append(out, " (focus_point ", sense.focus_distance);
    append(out, " ", sense.focus_direction);
    out.push_back(')');
  }

  out.push_back(')');
}

}  // namespace cls::soccer
