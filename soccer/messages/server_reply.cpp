// Parsing of short server messages.
#include "soccer/messages/server_reply.h"

#include <iterator>

#include "soccer/messages/sense_groups.h"
#include "soccer/protocol/observation_name.h"
#include "soccer/protocol/scanner.h"

namespace cls::soccer {
namespace {

bool read_mode(Scanner& in, PlayMode& mode) {
  std::string_view text;
  const std::size_t start = in.position();
  if (!in.token(text)) return false;
  const std::optional<PlayMode> known = parse_play_mode(text);
  if (!known) return in.fail_at(start, "a play mode");

  mode = *known;
  return true;
}

bool read_plain_team(Scanner& in, TeamName& team) {
  std::string_view text;
  const std::size_t start = in.position();
  if (!in.token(text)) return false;

  if (text.size() > TeamName::kMaxSize) return in.fail_at(start, "a team name");
  team = TeamName(text);
  return true;
}

bool read_on_off(Scanner& in, bool& on) {
  on = in.optional("on)");
  return on || in.optional("off)") || in.fail("on or off");
}

// "(init l 1 MODE)", "(init l ok)", "(init ok)"
bool read_init(Scanner& in, ServerReply& out) {
  Side side = Side::kNeutral;
  if (!in.looking_at("ok)") && !(read_side(in, side) && in.literal(" "))) return false;
  if (in.optional("ok)")) {
    out = CoachInitReply{side};
    return true;
  }

  auto& reply = out.emplace<PlayerInitReply>();
  reply.side = side;
  return in.integer(reply.unum, 1, kPlayersPerTeam) && in.literal(" ") &&
         read_mode(in, reply.mode) && in.literal(")");
}

bool read_reconnect(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<ReconnectReply>();
  return read_side(in, reply.side) && in.literal(" ") && read_mode(in, reply.mode) &&
         in.literal(")");
}

template <typename Reply, typename Parse>
bool read_coded(Scanner& in, Parse parse_code, ServerReply& out) {
  std::string_view text;
  if (!in.rest_before(")", text)) return false;
  out = Reply{std::string(text), parse_code(text)};
  return true;
}

bool read_score(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<ScoreReply>();
  return in.sequence(reply.time, " ", reply.our, " ", reply.opponent, ")");
}

bool read_type_change(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<PlayerTypeChange>();
  if (in.peek() == 'l' || in.peek() == 'r') {
    return read_side(in, reply.goalie_side) && in.literal(" ") &&
           in.integer(reply.unum, 1, kPlayersPerTeam) && in.literal(" goalie)");
  }

  if (!in.integer(reply.unum, 1, kPlayersPerTeam)) return false;
  return in.optional(")") || in.sequence(" ", reply.type.emplace(), ")");
}

bool read_clang(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<ClangSupport>();
  return in.literal("(ver (p ") && read_player(in, reply.team, reply.unum, reply.goalie) &&
         in.sequence(") ", reply.min_version, " ", reply.max_version, "))");
}

bool read_include(Scanner& in, ServerReply& out) {
  int size = 0;
  std::string_view text;
  const std::size_t start = in.position();

  if (!(in.sequence(size, " ") && in.rest_before(")", text))) return false;
  if (size != std::ssize(text)) return in.fail_at(start, "the length of the text");

  out = CoachInclude{std::string(text)};
  return true;
}

bool read_ok_clang(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<OkClang>();
  return in.sequence("(ver ", reply.min_version, " ", reply.max_version, "))");
}

bool read_ok_team_names(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<OkTeamNames>();
  const auto read_name = [&in](std::string_view start, TeamName& team) {
    return !in.optional(start) || (read_plain_team(in, team) && in.literal(")"));
  };

  if (!(read_name(" (team l ", reply.left) && read_name(" (team r ", reply.right))) return false;
  return in.literal(")") && (in.optional("\n"), true);
}

bool read_ok_check_ball(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<OkCheckBall>();

  if (!in.sequence(reply.time, " ")) return false;
  for (const BallPlace place :
       {BallPlace::kInField, BallPlace::kGoalLeft, BallPlace::kGoalRight, BallPlace::kOutOfField}) {
    if (!in.optional(name(place))) continue;
    reply.place = place;
    return in.literal(")");
  }

  return in.fail("a place");
}

// "UNUM TYPE", "UNUM goalie" or "TEAM UNUM TYPE"; a team may be named 7, so the tokens are counted.
bool read_ok_change_player_type(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<OkChangePlayerType>();
  const std::string_view rest = in.rest();
  const bool has_team = rest.find(' ') != rest.rfind(' ');

  if (has_team && !(read_plain_team(in, reply.team) && in.literal(" "))) return false;
  if (!(in.integer(reply.unum, 1, kPlayersPerTeam) && in.literal(" "))) return false;
  if (!has_team && in.optional("goalie)")) return true;
  return in.sequence(reply.type.emplace(), ")");
}

bool read_ok_team_graphic(Scanner& in, ServerReply& out) {
  auto& reply = out.emplace<OkTeamGraphic>();
  return in.sequence(reply.x, " ", reply.y, ")");
}

// Consumes `text`, the rest of a reply without parameters.
template <typename Reply>
bool read_plain(Scanner& in, std::string_view text, ServerReply& out) {
  if (!in.optional(text)) return false;
  out = Reply{};
  return true;
}

bool read_ok(Scanner& in, ServerReply& out) {
  if (in.optional("clang ")) return read_ok_clang(in, out);
  if (in.optional("compression ")) return in.sequence(out.emplace<OkCompression>().level, ")");
  if (in.optional("eye ")) return read_on_off(in, out.emplace<OkEye>().on);
  if (in.optional("ear ")) return read_on_off(in, out.emplace<OkEar>().on);
  if (in.optional("team_names")) return read_ok_team_names(in, out);
  if (in.optional("check_ball ")) return read_ok_check_ball(in, out);
  if (in.optional("change_player_type ")) return read_ok_change_player_type(in, out);
  if (in.optional("team_graphic ")) return read_ok_team_graphic(in, out);

  if (read_plain<OkRecover>(in, "recover)", out)) {
    in.optional("\n");
    return true;
  }

  return read_plain<OkSynchSee>(in, "synch_see)", out) ||
         read_plain<OkGaussianSee>(in, "gaussian_see)", out) ||
         read_plain<OkSay>(in, "say)", out) || read_plain<OkStart>(in, "start)", out) ||
         read_plain<OkChangeMode>(in, "change_mode)", out) ||
         read_plain<OkMove>(in, "move)", out) || in.fail("a known reply");
}

bool read_reply(Scanner& in, ServerReply& out) {
  if (read_plain<Think>(in, "(think)", out)) return true;
  if (in.optional("(ok ")) return read_ok(in, out);
  if (in.optional("(init ")) return read_init(in, out);
  if (in.optional("(reconnect ")) return read_reconnect(in, out);
  if (in.optional("(error ")) return read_coded<ErrorReply>(in, parse_error_code, out);
  if (in.optional("(warning ")) return read_coded<WarningReply>(in, parse_warning_code, out);
  if (in.optional("(score ")) return read_score(in, out);
  if (in.optional("(change_player_type ")) return read_type_change(in, out);
  if (in.optional("(clang ")) return read_clang(in, out);
  if (in.optional("(include ")) return read_include(in, out);
  return in.fail("a server reply");
}

}  // namespace

base::Result<void> parse(std::string_view message, ServerReply& out) {
  Scanner in(message);
  return in.finish(read_reply(in, out), "reply");
}

}  // namespace cls::soccer
