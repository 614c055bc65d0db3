// Formatting of short server messages.
#include "soccer/messages/sense_groups.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/observation_name.h"

namespace cls::soccer {
namespace {

void write(const PlayerInitReply& reply, std::string& out) {
  out.append("(init ").push_back(letter(reply.side));
  append(out, " ", reply.unum);
  out.append(" ").append(name(reply.mode)).push_back(')');
}

void write(const ReconnectReply& reply, std::string& out) {
  out.append("(reconnect ").push_back(letter(reply.side));
  out.append(" ").append(name(reply.mode)).push_back(')');
}

void write(const CoachInitReply& reply, std::string& out) {
  out.append("(init ");

  if (reply.side != Side::kNeutral) {
    out.push_back(letter(reply.side));
    out.push_back(' ');
  }
  out.append("ok)");
}

void write(const ErrorReply& reply, std::string& out) {
  out.append("(error ").append(reply.text).push_back(')');
}

void write(const WarningReply& reply, std::string& out) {
  out.append("(warning ").append(reply.text).push_back(')');
}

void write(const ScoreReply& reply, std::string& out) {
  append(out, "(score ", reply.time);
  append(out, " ", reply.our);
  append(out, " ", reply.opponent);
  out.push_back(')');
}

void write(const PlayerTypeChange& reply, std::string& out) {
  out.append("(change_player_type ");

  if (reply.goalie_side != Side::kNeutral) {
    out.push_back(letter(reply.goalie_side));
    append(out, " ", reply.unum);
    out.append(" goalie)");
    return;
  }

  base::append_int(reply.unum, out);
  if (reply.type) append(out, " ", *reply.type);
  out.push_back(')');
}

void write(const ClangSupport& reply, std::string& out) {
  out.append("(clang (ver (p ");
  append_player(reply.team, reply.unum, reply.goalie, out);
  append(out, ") ", reply.min_version);
  append(out, " ", reply.max_version);
  out.append("))");
}

void write(const CoachInclude& reply, std::string& out) {
  append(out, "(include ", static_cast<int>(reply.text.size()));
  out.append(" ").append(reply.text).push_back(')');
}

void write(const OkClang& reply, std::string& out) {
  append(out, "(ok clang (ver ", reply.min_version);
  append(out, " ", reply.max_version);
  out.append("))");
}

void write(const OkCompression& reply, std::string& out) {
  append(out, "(ok compression ", reply.level);
  out.push_back(')');
}

void write(const OkEye& reply, std::string& out) {
  out.append(reply.on ? "(ok eye on)" : "(ok eye off)");
}

void write(const OkEar& reply, std::string& out) {
  out.append(reply.on ? "(ok ear on)" : "(ok ear off)");
}

void write(const OkTeamNames& reply, std::string& out) {
  out.append("(ok team_names");
  if (!reply.left.empty()) out.append(" (team l ").append(reply.left.view()).push_back(')');
  if (!reply.right.empty()) out.append(" (team r ").append(reply.right.view()).push_back(')');
  out.append(")\n");
}

void write(const OkCheckBall& reply, std::string& out) {
  append(out, "(ok check_ball ", reply.time);
  out.append(" ").append(name(reply.place)).push_back(')');
}

void write(const OkChangePlayerType& reply, std::string& out) {
  out.append("(ok change_player_type ");
  if (!reply.team.empty()) out.append(reply.team.view()).push_back(' ');

  base::append_int(reply.unum, out);
  out.push_back(' ');

  if (reply.type) {
    base::append_int(*reply.type, out);
  } else {
    out.append("goalie");
  }

  out.push_back(')');
}

void write(const OkTeamGraphic& reply, std::string& out) {
  append(out, "(ok team_graphic ", reply.x);
  append(out, " ", reply.y);
  out.push_back(')');
}

void write(Think, std::string& out) { out.append("(think)"); }
void write(OkSynchSee, std::string& out) { out.append("(ok synch_see)"); }
void write(OkGaussianSee, std::string& out) { out.append("(ok gaussian_see)"); }
void write(OkSay, std::string& out) { out.append("(ok say)"); }
void write(OkStart, std::string& out) { out.append("(ok start)"); }
void write(OkChangeMode, std::string& out) { out.append("(ok change_mode)"); }
void write(OkMove, std::string& out) { out.append("(ok move)"); }
void write(OkRecover, std::string& out) { out.append("(ok recover)\n"); }

}  // namespace

std::string_view name(BallPlace place) {
  switch (place) {
    case BallPlace::kInField:
      return "in_field";
    case BallPlace::kGoalLeft:
      return "goal_l";
    case BallPlace::kGoalRight:
      return "goal_r";
    case BallPlace::kOutOfField:
      break;
  }
  return "out_of_field";
}

void format(const ServerReply& reply, std::string& out) {
  std::visit([&out](const auto& one) { write(one, out); }, reply);
}

}  // namespace cls::soccer
