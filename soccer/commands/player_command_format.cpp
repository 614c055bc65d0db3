// Formatting of player commands.
#include <algorithm>
#include <initializer_list>

#include "base/text/enum_names.h"
#include "soccer/commands/command_writing.h"
#include "soccer/commands/player_command.h"
#include "soccer/commands/player_command_lexer.h"

namespace cls::soccer {
namespace {

// "(NAME A B)"; false if a number is not finite.
bool write(std::string_view name, std::initializer_list<double> numbers, std::string& out) {
  out.append("(").append(name);
  for (const double number : numbers) {
    if (!write_number(number, out)) return false;
  }

  out.push_back(')');
  return true;
}

bool write(const TeamReference& team, std::string& out) {
  constexpr auto kKinds = base::enum_names<TeamReference::Kind>("our", "opp", "l", "r");
  if (team.kind != TeamReference::Kind::kNamed) return write_text(kKinds.name(team.kind), out);

  const CommandToken token = CommandLexer(team.name).next();
  const bool plain = token.kind == CommandToken::Kind::kName && !is_command_keyword(token.text);
  if (!plain && token.kind != CommandToken::Kind::kQuoted) return false;
  return token.text == team.name && write_text(team.name, out);
}

bool write(const Turn& c, std::string& out) { return write("turn", {c.moment}, out); }
bool write(const Dash& c, std::string& out) {
  if (c.direction == 0.0) return write("dash", {c.power}, out);
  return write("dash", {c.power, c.direction}, out);
}
bool write(const TurnNeck& c, std::string& out) { return write("turn_neck", {c.moment}, out); }
bool write(const ChangeFocus& c, std::string& out) {
  return write("change_focus", {c.moment_distance, c.moment_direction}, out);
}
bool write(const Kick& c, std::string& out) { return write("kick", {c.power, c.direction}, out); }
bool write(const LongKick& c, std::string& out) {
  return write("long_kick", {c.power, c.direction}, out);
}
bool write(const Catch& c, std::string& out) { return write("catch", {c.direction}, out); }
bool write(const Move& c, std::string& out) { return write("move", {c.x, c.y}, out); }
bool write(const PointTo& c, std::string& out) {
  return write("pointto", {c.distance, c.direction}, out);
}

bool write(const LegDash& c, std::string& out) {
  if (!c.left && !c.right) return false;

  out.append("(dash ");
  if (c.left && !write("l", {c.left->power, c.left->direction}, out)) return false;
  if (c.left && c.right) out.push_back(' ');
  if (c.right && !write("r", {c.right->power, c.right->direction}, out)) return false;

  out.push_back(')');
  return true;
}

bool write(const Tackle& c, std::string& out) {
  if (!write("tackle", {c.angle_or_power}, out)) return false;
  if (!c.foul) return true;

  out.pop_back();
  return write_text(" on)", out);
}

bool write(const ChangeView& c, std::string& out) {
  append(out, "(change_view ", name(c.width));
  if (c.quality) append(out, ' ', name(*c.quality));
  return write_text(")", out);
}

bool write(const Say& c, std::string& out) {
  return is_sayable(c.text) && write_pieces(out, "(say \"", c.text, "\")");
}

bool write(const AttentionTo& c, std::string& out) {
  out.append("(attentionto ");
  return write(c.team, out) && write_pieces(out, ' ', c.unum, ')');
}

bool write(const Ear& c, std::string& out) {
  out.append(c.on ? "(ear (on" : "(ear (off");

  if (c.team) {
    out.push_back(' ');
    if (!write(*c.team, out)) return false;
  }

  if (c.mode) out.append(*c.mode == EarMode::kPartial ? " partial" : " complete");
  return write_text("))", out);
}

bool write(const Clang& c, std::string& out) {
  return write_pieces(out, "(clang (ver ", c.min_version, ' ', c.max_version, "))");
}

bool write(SynchSee, std::string& out) { return write_text("(synch_see)", out); }
bool write(GaussianSee, std::string& out) { return write_text("(gaussian_see)", out); }
bool write(PointToOff, std::string& out) { return write_text("(pointto off)", out); }
bool write(AttentionToOff, std::string& out) { return write_text("(attentionto off)", out); }
bool write(RequestSenseBody, std::string& out) { return write_text("(sense_body)", out); }
bool write(RequestScore, std::string& out) { return write_text("(score)", out); }

}  // namespace

bool is_sayable(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_say_character);
}

bool format(const PlayerCommand& command, std::string& out) {
  return write_command(command, out,
                       [](const auto& one, std::string& to) { return write(one, to); });
}

}  // namespace cls::soccer
