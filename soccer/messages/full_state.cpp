// Parsing and formatting of fullstate.
#include "soccer/messages/full_state.h"

#include "soccer/messages/sense_groups.h"
#include "soccer/protocol/scanner.h"

namespace cls::soccer {
namespace {

constexpr std::string_view kCatchPrefix = "goalie_catch_ball_";

// First client versions that receive a field.
constexpr int kFirstWithMarks = 13;  // and the capacity
constexpr int kFirstWithGoalieType = 14;
constexpr int kFirstWithCards = 14;  // and the mark of a fouled player
constexpr int kFirstWithFocus = 18;

bool read_mode(Scanner& in, FullState& out) {
  std::string_view mode;
  const std::size_t start = in.position();
  if (!in.token(mode)) return false;

  out.ball_caught = mode == "goalie_catch_ball_l" || mode == "goalie_catch_ball_r";
  if (out.ball_caught) {
    out.mode = mode.back() == 'l' ? PlayMode::kFreeKickLeft : PlayMode::kFreeKickRight;
    return true;
  }

  const std::optional<PlayMode> known = parse_play_mode(mode);
  if (!known) return in.fail_at(start, "a play mode");

  out.mode = *known;
  return true;
}

bool read_counts(Scanner& in, CommandCounts& counts, bool& has_focus) {
  counts.change_focus = 0;
  if (!in.sequence(" (count ", counts.kick, " ", counts.dash, " ", counts.turn, " ", counts.catches,
                   " ", counts.move, " ", counts.turn_neck, " ", counts.change_view, " ",
                   counts.say)) {
    return false;
  }

  has_focus = in.optional(" ");
  return (!has_focus || in.integer(counts.change_focus)) && in.literal(")");
}

bool read_name(Scanner& in, FullStatePlayer& player) {
  if (!(in.literal(" ((p ") && read_side(in, player.side) && in.literal(" ") &&
        in.integer(player.unum, 1, kPlayersPerTeam) && in.literal(" "))) {
    return false;
  }

  player.goalie = in.optional("g ");
  return in.integer(player.type) && in.literal(") ");
}

bool read_pointing(Scanner& in, FullStatePlayer& player) {
  player.pointing = !in.looking_at(" (");
  return !player.pointing ||
         in.sequence(" ", player.point_distance, " ", player.point_direction_radians);
}

bool read_player(Scanner& in, bool has_focus, FullStatePlayer& player) {
  if (!(read_name(in, player) && read_motion(in, player.position, player.velocity) &&
        in.sequence(" ", player.body, " ", player.neck) && read_pointing(in, player))) {
    return false;
  }
  if (has_focus &&
      !in.sequence(" (focus_point ", player.focus_distance, " ", player.focus_direction, ")")) {
    return false;
  }
  if (!in.sequence(" (stamina ", player.stamina, " ", player.effort, " ", player.recovery, " ",
                   player.capacity, ")")) {
    return false;
  }

  read_marks(in, player.mark, player.card);
  return in.literal(")");
}

void append_counts(const CommandCounts& counts, int version, TextWriter& out) {
  append(out, " (count ", counts.kick, ' ', counts.dash, ' ', counts.turn, ' ', counts.catches, ' ',
         counts.move, ' ', counts.turn_neck, ' ', counts.change_view, ' ', counts.say);
  if (version >= kFirstWithFocus) append(out, " ", counts.change_focus);
  out.append(") ");
}

void append_name(const FullStatePlayer& player, int version, TextWriter& out) {
  append(out, " ((p ", letter(player.side), ' ', player.unum);
  if (player.goalie) out.append(" g");
  if (!player.goalie || version >= kFirstWithGoalieType) append(out, " ", player.type);
  out.append(") ");
}

// The mark of a player in a client version.
ActionMark mark_shown(const FullStatePlayer& player, int version) {
  const bool fouled = player.mark == ActionMark::kFoulCharged;
  const bool hidden = version < (fouled ? kFirstWithCards : kFirstWithMarks);
  return hidden ? ActionMark::kNone : player.mark;
}

void append_player(const FullStatePlayer& player, int version, TextWriter& out) {
  append_name(player, version, out);
  append_motion(player.position, player.velocity, out);

  append(out, ' ', player.body, ' ', player.neck);

  if (player.pointing) append(out, ' ', player.point_distance, ' ', player.point_direction_radians);
  if (version >= kFirstWithFocus) {
    append(out, " (focus_point ", player.focus_distance, ' ', player.focus_direction, ')');
  }

  append(out, " (stamina ", player.stamina, ' ', player.effort, ' ', player.recovery);
  if (version >= kFirstWithMarks) append(out, " ", player.capacity);
  out.push_back(')');

  append_marks(mark_shown(player, version), version >= kFirstWithCards ? player.card : Card::kNone,
               out);
  out.push_back(')');
}

}  // namespace

base::Result<void> parse(std::string_view message, FullState& out) {
  Scanner in(message);
  bool has_focus = false;
  out.players.clear();

  const auto read = [&](FullStatePlayer& player) { return read_player(in, has_focus, player); };
  const bool whole = in.sequence("(fullstate ", out.time, " (pmode ") && read_mode(in, out) &&
                     in.literal(") (vmode ") && read_view_mode(in, out.quality, out.width) &&
                     in.literal(")") && read_counts(in, out.counts, has_focus) && in.literal(" ") &&
                     read_arm(in, out.arm) &&
                     in.sequence(" (score ", out.our_score, " ", out.opponent_score, ") ((b) ") &&
                     read_motion(in, out.ball_position, out.ball_velocity) && in.literal(")") &&
                     read_items(in, out.players, kPlayersOnPitch, "no more players", read);
  return in.finish(whole, "fullstate");
}

void format(const FullState& state, int version, std::string& text) {
  TextWriter out(text);
  append(out, "(fullstate ", state.time, " (pmode ");
  if (state.ball_caught) {
    append(out, kCatchPrefix, letter(side(state.mode)));
  } else {
    out.append(name(state.mode));
  }

  out.append(") (vmode ");
  append_view_mode(state.quality, state.width, out);
  out.push_back(')');
  append_counts(state.counts, version, out);
  append_arm(state.arm, out);

  append(out, " (score ", state.our_score, ' ', state.opponent_score, ") ((b) ");
  append_motion(state.ball_position, state.ball_velocity, out);
  out.push_back(')');

  for (const FullStatePlayer& player : state.players) append_player(player, version, out);
  out.push_back(')');
}

}  // namespace cls::soccer
