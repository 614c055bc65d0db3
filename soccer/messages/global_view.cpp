// Parsing and formatting of see_global and (ok look ...).
#include "soccer/messages/global_view.h"

#include "soccer/messages/sense_groups.h"
#include "soccer/protocol/observation_name.h"
#include "soccer/protocol/scanner.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

constexpr std::string_view kGoals = " ((g r) 52.5 0) ((g l) -52.5 0) ((b) ";

bool at_number(const Scanner& in) {
  return in.looking_at(" ") && in.rest().find_first_of("-0123456789", 1) == 1;
}

bool read_one(Scanner& in, GlobalViewPlayer& player) {
  if (!(in.literal(" ((p ") && read_player(in, player.team, player.unum, player.goalie) &&
        in.literal(") ") && read_motion(in, player.position, player.velocity) &&
        in.sequence(" ", player.body, " ", player.neck))) {
    return false;
  }

  player.pointing = at_number(in);
  if (player.pointing && !in.sequence(" ", player.point_direction)) return false;
  read_marks(in, player.mark, player.card);
  return in.literal(")");
}

}  // namespace

base::Result<void> parse(std::string_view message, GlobalView& out) {
  Scanner in(message);
  out.players.clear();
  out.is_look_reply = in.optional("(ok look ");
  const auto read = [&in](GlobalViewPlayer& player) { return read_one(in, player); };
  const bool whole = (out.is_look_reply || in.literal("(see_global ")) &&
                     in.sequence(out.time, kGoals) &&
                     read_motion(in, out.ball_position, out.ball_velocity) && in.literal(")") &&
                     read_items(in, out.players, kPlayersOnPitch, "no more players", read);
  return in.finish(whole, "see_global");
}

void format(const GlobalView& view, std::string& text) {
  TextWriter out(text);
  append(out, view.is_look_reply ? "(ok look " : "(see_global ", view.time, kGoals);
  append_motion(view.ball_position, view.ball_velocity, out);
  out.push_back(')');

  for (const GlobalViewPlayer& player : view.players) {
    out.append(" ((p ");
    append_player(player.team, player.unum, player.goalie, out);
    out.append(") ");
    append_motion(player.position, player.velocity, out);
    append(out, ' ', player.body, ' ', player.neck);
    if (player.pointing) append(out, ' ', player.point_direction);
    append_marks(player.mark, player.card, out);
    out.push_back(')');
  }

  out.push_back(')');
}

}  // namespace cls::soccer
