// Parsing and formatting of see.
#include "soccer/messages/see.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/text/rounded_number.h"
#include "soccer/messages/sense_groups.h"
#include "soccer/messages/values.h"
#include "soccer/pitch.h"
#include "soccer/protocol/observation_name.h"
#include "soccer/protocol/scanner.h"

namespace cls::soccer {
namespace {

bool read_line(Scanner& in, Observation& object) {
  for (int line = 0; line < kPitchLineCount; ++line) {
    const char name = letter(static_cast<PitchLine>(line));
    if (!in.optional(std::string_view(&name, 1))) continue;
    object.index = static_cast<std::uint8_t>(line);
    return true;
  }

  return in.fail("l, r, t or b");
}

bool read_player_name(Scanner& in, Observation& object) {
  if (in.peek() == ')') return true;
  if (!(in.literal(" ") && read_team(in, object.team))) return false;
  if (!in.optional(" ")) return true;

  int unum = 0;
  if (!in.integer(unum, 1, kPlayersPerTeam)) return false;
  object.unum = static_cast<std::uint8_t>(unum);
  object.goalie = in.optional(" goalie");
  return true;
}

// The name without parentheses.
bool read_name(Scanner& in, Observation& object) {
  struct Plain {
    std::string_view text;
    ObservedKind kind;
  };
  constexpr std::array<Plain, 5> kPlain = {{{"b)", ObservedKind::kBall},
                                            {"F)", ObservedKind::kCloseFlag},
                                            {"G)", ObservedKind::kCloseGoal},
                                            {"B)", ObservedKind::kCloseBall},
                                            {"P)", ObservedKind::kClosePlayer}}};

  const char first = in.peek();
  if (first == 'f' || first == 'g') {
    object.kind = ObservedKind::kLandmark;
    return read_landmark(in, object.index);
  }
  if (first == 'p') {
    object.kind = ObservedKind::kPlayer;
    return in.literal("p") && read_player_name(in, object);
  }
  if (in.optional("l ")) {
    object.kind = ObservedKind::kLine;
    return read_line(in, object);
  }

  for (const Plain& plain : kPlain) {
    if (!in.looking_at(plain.text)) continue;
    object.kind = plain.kind;
    return in.literal(plain.text.substr(0, 1));
  }

  return in.fail("an object name");
}

constexpr std::size_t kMaxNumbers = 7;

struct Numbers {
  std::array<double, kMaxNumbers> values;
  std::size_t count = 0;
};

bool read_numbers(Scanner& in, Numbers& numbers, ActionMark& mark) {
  while (in.optional(" ")) {
    const char next = in.peek();
    if (next == 't' || next == 'k') {
      mark = next == 't' ? ActionMark::kTackling : ActionMark::kKicked;
      return in.literal(next == 't' ? "t)" : "k)");
    }

    if (numbers.count == kMaxNumbers) return in.fail(")");
    if (!in.number(numbers.values[numbers.count++])) return false;
  }

  return in.literal(")");
}

bool whole(double value, std::int16_t& out) {
  if (!(std::fabs(value) <= std::numeric_limits<std::int16_t>::max())) return false;
  out = static_cast<std::int16_t>(value);
  return static_cast<double>(out) == value;
}

// Assigns the numbers after a name; their meaning depends on their count.
bool assign(const Numbers& numbers, Observation& object) {
  const auto& v = numbers.values;
  const bool player = object.kind == ObservedKind::kPlayer;
  const std::size_t count = numbers.count;

  if (count == 1) {
    object.detail = ObservedDetail::kDirection;
    return whole(v[0], object.direction);
  }

  object.distance = v[0];
  if (count < 2 || !whole(v[1], object.direction)) return false;
  if (count == 2 || (player && count == 3)) {
    object.detail = ObservedDetail::kPosition;
    object.pointing = count == 3;
    return !object.pointing || whole(v[2], object.point_direction);
  }

  if (count < 4 || player != (count >= 6) || count == 5) return false;
  object.distance_change = v[2];
  object.direction_change = v[3];
  object.detail = player ? ObservedDetail::kPose : ObservedDetail::kMotion;

  if (!player) return count == 4;

  object.pointing = count == 7;
  return whole(v[4], object.body) && whole(v[5], object.head) &&
         (!object.pointing || whole(v[6], object.point_direction));
}

bool read_object(Scanner& in, Observation& object) {
  Numbers numbers;
  if (!(in.literal(" ((") && read_name(in, object) && in.literal(")"))) return false;
  if (!read_numbers(in, numbers, object.mark)) return false;

  if (object.mark != ActionMark::kNone && object.kind != ObservedKind::kPlayer) {
    return in.fail("no mark on this object");
  }

  return assign(numbers, object) || in.fail("another set of numbers before this");
}

void append_name(const Observation& object, TextWriter& out) {
  switch (object.kind) {
    case ObservedKind::kLandmark:
      assert(object.index < kLandmarkCount);
      out.append(kLandmarks[object.index].name);
      break;
    case ObservedKind::kBall:
      out.push_back('b');
      break;
    case ObservedKind::kPlayer:
      out.push_back('p');
      if (object.team.empty()) break;
      out.push_back(' ');
      if (object.unum > 0) {
        append_player(object.team, object.unum, object.goalie, out);
      } else {
        append(out, '"', object.team.view(), '"');
      }
      break;
    case ObservedKind::kLine:
      assert(object.index < kPitchLineCount);
      append(out, "l ", letter(static_cast<PitchLine>(object.index)));
      break;
    case ObservedKind::kCloseFlag:
      out.push_back('F');
      break;
    case ObservedKind::kCloseGoal:
      out.push_back('G');
      break;
    case ObservedKind::kCloseBall:
      out.push_back('B');
      break;
    case ObservedKind::kClosePlayer:
      out.push_back('P');
      break;
  }
}

void append_numbers(const Observation& object, TextWriter& out) {
  if (object.detail != ObservedDetail::kDirection) append(out, ' ', object.distance);
  append(out, ' ', object.direction);
  if (object.detail >= ObservedDetail::kMotion) {
    append(out, ' ', object.distance_change, ' ', object.direction_change);
  }
  if (object.detail == ObservedDetail::kPose) append(out, ' ', object.body, ' ', object.head);

  if (object.pointing) append(out, ' ', object.point_direction);
  if (object.mark == ActionMark::kTackling) out.append(" t");
  if (object.mark == ActionMark::kKicked) out.append(" k");
}

// True if the numbers and marks that the text of an object has are those of its kind.
bool has_usual_form(const Observation& object) {
  if (!std::isfinite(object.distance) || !std::isfinite(object.distance_change) ||
      !std::isfinite(object.direction_change)) {
    return false;
  }
  const ObservedDetail detail = object.detail;
  if (object.kind == ObservedKind::kPlayer) {
    return detail != ObservedDetail::kMotion &&
           !(object.pointing && detail == ObservedDetail::kDirection);
  }
  return detail != ObservedDetail::kPose && !object.pointing && object.mark == ActionMark::kNone;
}

// What the text of an object says of it.
Observation as_sent(const Observation& object) {
  Observation sent;
  sent.kind = object.kind;
  sent.detail = object.detail;
  sent.direction = object.direction;
  if (object.kind == ObservedKind::kLandmark || object.kind == ObservedKind::kLine) {
    sent.index = object.index;
  }
  if (object.kind == ObservedKind::kPlayer && !object.team.empty()) {
    sent.team = object.team;
    sent.unum = object.unum;
    sent.goalie = object.goalie && object.unum > 0;
  }

  if (object.detail != ObservedDetail::kDirection) {
    sent.distance = base::rounded_to_text(object.distance);
  }
  if (object.detail >= ObservedDetail::kMotion) {
    sent.distance_change = base::rounded_to_text(object.distance_change);
    sent.direction_change = base::rounded_to_text(object.direction_change);
  }
  if (object.detail == ObservedDetail::kPose) {
    sent.body = object.body;
    sent.head = object.head;
  }

  sent.pointing = object.pointing;
  if (object.pointing) sent.point_direction = object.point_direction;
  if (object.mark != ActionMark::kFoulCharged) sent.mark = object.mark;
  return sent;
}

}  // namespace

bool make_as_sent(See& see) {
  for (Observation& object : see.objects) {
    if (!has_usual_form(object)) return false;
    object = as_sent(object);
  }
  return true;
}

base::Result<void> parse(std::string_view message, See& out) {
  Scanner in(message);
  out.objects.clear();

  const auto read = [&in](Observation& object) { return read_object(in, object); };
  return in.finish(in.sequence("(see ", out.time) &&
                       read_items(in, out.objects, kMaxObservations, "no more objects", read),
                   "see");
}

void format(const See& see, std::string& text) {
  TextWriter out(text);
  append(out, "(see ", see.time);

  for (const Observation& object : see.objects) {
    out.append(" ((");
    append_name(object, out);
    out.push_back(')');
    append_numbers(object, out);
    out.push_back(')');
  }

  out.push_back(')');
}

}  // namespace cls::soccer
