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
  out.append("(change_player_type ");
  base::append_int(c.unum, out);
  if (!c.type) return write_text(" goalie)", out);

  out.push_back(' ');
  base::append_int(*c.type, out);
  return write_text(")", out);
}

bool write(const TrainerChangePlayerType& c, std::string& out) {
  if (!is_token(c.team)) return false;
  out.append("(change_player_type ").append(c.team).push_back(' ');
  base::append_int(c.unum, out);
  out.push_back(' ');
  base::append_int(c.type, out);
  return write_text(")", out);
}

bool write(const CoachSay& c, std::string& out) {
  const std::string message = c.text + ")";
  const std::optional<CoachSay> read = parse_clang_say(message);
  if (!read || read->kind != c.kind) return false;

  out.append("(say ").append(message);
  return true;
}

bool write(const TrainerSay& c, std::string& out) {
  if (!is_sayable(c.text) || c.text.front() == ' ') return false;
  out.append("(say ").append(c.text).push_back(')');
  return true;
}

bool write(const TeamGraphic& c, std::string& out) {
  out.append("(team_graphic (");
  base::append_int(c.x, out);
  out.push_back(' ');
  base::append_int(c.y, out);

  for (const std::string& line : c.xpm) {
    if (line.find('"') != std::string::npos) return false;
    out.append(" \"").append(line).push_back('"');
  }

  return write_text("))", out);
}

bool write(const ChangeMode& c, std::string& out) {
  if (c.mode == PlayMode::kNull) return false;
  out.append("(change_mode ").append(name(c.mode)).push_back(')');
  return true;
}

bool write(const MoveBall& c, std::string& out) {
  out.append("(move (ball)");
  return write_placement(c.position, c.angle, c.velocity, out);
}

bool write(const MovePlayer& c, std::string& out) {
  if (!is_token(c.team)) return false;

  std::string object = "player " + c.team + ' ';
  base::append_int(c.unum, object);
  if (object.size() > kMaxMoveObjectSize) return false;

  out.append("(move (").append(object).push_back(')');
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
