// Formatting of coach and trainer commands.
#include "soccer/commands/clang_frame.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/command_writing.h"

namespace cls::soccer {
namespace {

bool is_token(std::string_view text) {
  return !text.empty() && text.find_first_of(" \t\n\v\f\r()") == std::string_view::npos;
}

// "X Y [ANG [VX VY]])" after the object.
bool write_placement(Vec2 position, const std::optional<double>& angle,
                     const std::optional<Vec2>& velocity, std::string& out) {
  if (velocity && !angle) return false;
  return write_number(position.x, out) && write_number(position.y, out) &&
         (!angle || write_number(*angle, out)) &&
         (!velocity || (write_number(velocity->x, out) && write_number(velocity->y, out))) &&
         write_text(")", out);
}

bool write(const Eye& c, std::string& out) {
  return write_text(c.on ? "(eye on)" : "(eye off)", out);
}
bool write(const TrainerEar& c, std::string& out) {
  return write_text(c.on ? "(ear on)" : "(ear off)", out);
}

bool write(const ChangePlayerType& c, std::string& out) {
  append(out, "(change_player_type ", c.unum);
  return c.type ? write_pieces(out, ' ', *c.type, ')') : write_text(" goalie)", out);
}

bool write(const TrainerChangePlayerType& c, std::string& out) {
  return is_token(c.team) &&
         write_pieces(out, "(change_player_type ", c.team, ' ', c.unum, ' ', c.type, ')');
}

bool write(const CoachSay& c, std::string& out) {
  const std::string message = c.text + ")";
  const std::optional<CoachSay> read = parse_clang_say(message);
  return read && read->kind == c.kind && write_pieces(out, "(say ", message);
}

bool write(const TrainerSay& c, std::string& out) {
  return is_sayable(c.text) && c.text.front() != ' ' && write_pieces(out, "(say ", c.text, ')');
}

bool write(const TeamGraphic& c, std::string& out) {
  append(out, "(team_graphic (", c.x, ' ', c.y);
  for (const std::string& line : c.xpm) {
    if (line.find('"') != std::string::npos) return false;
    append(out, " \"", line, '"');
  }

  return write_text("))", out);
}

bool write(const ChangeMode& c, std::string& out) {
  return c.mode != PlayMode::kNull && write_pieces(out, "(change_mode ", name(c.mode), ')');
}

bool write(const MoveBall& c, std::string& out) {
  out.append("(move (ball)");
  return write_placement(c.position, c.angle, c.velocity, out);
}

bool write(const MovePlayer& c, std::string& out) {
  if (!is_token(c.team)) return false;

  std::string object;
  append(object, "player ", c.team, ' ', c.unum);
  if (object.size() > kMaxMoveObjectSize) return false;

  append(out, "(move (", object, ')');
  return write_placement(c.position, c.angle, c.velocity, out);
}

bool write(Look, std::string& out) { return write_text("(look)", out); }
bool write(RequestTeamNames, std::string& out) { return write_text("(team_names)", out); }
bool write(CheckBall, std::string& out) { return write_text("(check_ball)", out); }
bool write(Start, std::string& out) { return write_text("(start)", out); }
bool write(Recover, std::string& out) { return write_text("(recover)", out); }

}  // namespace

bool format(const CoachCommand& command, std::string& out) {
  return write_command(command, out,
                       [](const auto& one, std::string& to) { return write(one, to); });
}

}  // namespace cls::soccer
