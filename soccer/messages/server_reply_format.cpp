// Formatting of short server messages.
#include "base/text/enum_names.h"
#include "soccer/messages/sense_groups.h"
#include "soccer/messages/server_reply.h"
#include "soccer/protocol/observation_name.h"

namespace cls::soccer {
namespace {

constexpr auto kPlaces =
    base::enum_names<BallPlace>("in_field", "goal_l", "goal_r", "out_of_field");

void write(const PlayerInitReply& reply, std::string& out) {
  append(out, "(init ", letter(reply.side), ' ', reply.unum, ' ', name(reply.mode), ')');
}

void write(const ReconnectReply& reply, std::string& out) {
  append(out, "(reconnect ", letter(reply.side), ' ', name(reply.mode), ')');
}

void write(const CoachInitReply& reply, std::string& out) {
  out.append("(init ");
  if (reply.side != Side::kNeutral) append(out, letter(reply.side), ' ');
  out.append("ok)");
}

void write(const ErrorReply& reply, std::string& out) { append(out, "(error ", reply.text, ')'); }

void write(const WarningReply& reply, std::string& out) {
  append(out, "(warning ", reply.text, ')');
}

void write(const ScoreReply& reply, std::string& out) {
  append(out, "(score ", reply.time, ' ', reply.our, ' ', reply.opponent, ')');
}

void write(const PlayerTypeChange& reply, std::string& out) {
  out.append("(change_player_type ");
  if (reply.goalie_side != Side::kNeutral) {
    append(out, letter(reply.goalie_side), ' ', reply.unum, " goalie)");
    return;
  }

  append(out, reply.unum);
  if (reply.type) append(out, ' ', *reply.type);
  out.push_back(')');
}

void write(const ClangSupport& reply, std::string& out) {
  out.append("(clang (ver (p ");
  append_player(reply.team, reply.unum, reply.goalie, out);
  append(out, ") ", reply.min_version, ' ', reply.max_version, "))");
}

void write(const CoachInclude& reply, std::string& out) {
  append(out, "(include ", static_cast<int>(reply.text.size()), ' ', reply.text, ')');
}

void write(const OkClang& reply, std::string& out) {
  append(out, "(ok clang (ver ", reply.min_version, ' ', reply.max_version, "))");
}

void write(const OkCompression& reply, std::string& out) {
  append(out, "(ok compression ", reply.level, ')');
}

void write(const OkEye& reply, std::string& out) {
  out.append(reply.on ? "(ok eye on)" : "(ok eye off)");
}

void write(const OkEar& reply, std::string& out) {
  out.append(reply.on ? "(ok ear on)" : "(ok ear off)");
}

void write(const OkTeamNames& reply, std::string& out) {
  out.append("(ok team_names");
  if (!reply.left.empty()) append(out, " (team l ", reply.left.view(), ')');
  if (!reply.right.empty()) append(out, " (team r ", reply.right.view(), ')');
  out.append(")\n");
}

void write(const OkCheckBall& reply, std::string& out) {
  append(out, "(ok check_ball ", reply.time, ' ', name(reply.place), ')');
}

void write(const OkChangePlayerType& reply, std::string& out) {
  out.append("(ok change_player_type ");
  if (!reply.team.empty()) append(out, reply.team.view(), ' ');
  append(out, reply.unum, ' ');

  if (reply.type) {
    append(out, *reply.type, ')');
  } else {
    out.append("goalie)");
  }
}

void write(const OkTeamGraphic& reply, std::string& out) {
  append(out, "(ok team_graphic ", reply.x, ' ', reply.y, ')');
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

std::string_view name(BallPlace place) { return kPlaces.name(place); }

void format(const ServerReply& reply, std::string& out) {
  std::visit([&out](const auto& one) { write(one, out); }, reply);
}

}  // namespace cls::soccer
