// Short server messages: connection replies, (ok ...), (error ...), (warning ...), (think), ...
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.h"
#include "soccer/play_mode.h"
#include "soccer/protocol/reply_code.h"
#include "soccer/protocol/team_name.h"
#include "soccer/side.h"

namespace cls::soccer {

/// `(init l 1 before_kick_off)`
struct PlayerInitReply {
  Side side = Side::kLeft;
  int unum = 0;
  PlayMode mode = PlayMode::kBeforeKickOff;
};
/// `(reconnect l before_kick_off)`
struct ReconnectReply {
  Side side = Side::kLeft;
  PlayMode mode = PlayMode::kBeforeKickOff;
};
/// `(init l ok)` to an online coach, `(init ok)` to a trainer (side neutral).
struct CoachInitReply {
  Side side = Side::kNeutral;
};
/// `(error X)`; `code` is empty for unknown texts.
struct ErrorReply {
  std::string text;
  std::optional<ErrorCode> code;
};
/// `(warning X)`
struct WarningReply {
  std::string text;
  std::optional<WarningCode> code;
};
/// `(think)`: in synch mode, the server waits for (done).
struct Think {};
/// `(score T OUR OPP)`
struct ScoreReply {
  int time = 0;
  int our = 0;
  int opponent = 0;
};
/// `(change_player_type UNUM TYPE)` for the own team, `(change_player_type UNUM)` for the other
/// team, `(change_player_type SIDE UNUM goalie)` for either.
struct PlayerTypeChange {
  int unum = 0;
  std::optional<int> type;
  Side goalie_side = Side::kNeutral;  ///< not neutral: the goalie form
};
/// `(clang (ver (p "TEAM" UNUM) MIN MAX))`: a player has sent its coach language versions.
struct ClangSupport {
  TeamName team;
  int unum = 0;
  bool goalie = false;
  int min_version = 0;
  int max_version = 0;
};
/// `(include N TEXT)`: the coach message file of the server.
struct CoachInclude {
  std::string text;
};

struct OkSynchSee {};
struct OkGaussianSee {};
/// `(ok clang (ver MIN MAX))`
struct OkClang {
  int min_version = 0;
  int max_version = 0;
};
struct OkCompression {
  int level = 0;
};
struct OkEye {
  bool on = true;
};
struct OkEar {
  bool on = true;
};
/// `(ok team_names (team l A) (team r B))`; empty names are omitted.
struct OkTeamNames {
  TeamName left;
  TeamName right;
};
enum class BallPlace : std::uint8_t { kInField, kGoalLeft, kGoalRight, kOutOfField };
/// "in_field", "goal_l", "goal_r", "out_of_field"
std::string_view name(BallPlace place);
struct OkCheckBall {
  int time = 0;
  BallPlace place = BallPlace::kInField;
};
/// `(ok change_player_type UNUM TYPE)`, `(ok change_player_type UNUM goalie)` (no type), and to a
/// trainer `(ok change_player_type TEAM UNUM TYPE)`.
struct OkChangePlayerType {
  TeamName team;
  int unum = 0;
  std::optional<int> type;
};
struct OkSay {};
struct OkTeamGraphic {
  int x = 0;
  int y = 0;
};
struct OkStart {};
struct OkChangeMode {};
struct OkMove {};
struct OkRecover {};

using ServerReply = std::variant<PlayerInitReply, ReconnectReply, CoachInitReply, ErrorReply,
                                 WarningReply, Think, ScoreReply, PlayerTypeChange, ClangSupport,
                                 CoachInclude, OkSynchSee, OkGaussianSee, OkClang, OkCompression,
                                 OkEye, OkEar, OkTeamNames, OkCheckBall, OkChangePlayerType, OkSay,
                                 OkTeamGraphic, OkStart, OkChangeMode, OkMove, OkRecover>;

/// The reply of a code.
inline ServerReply reply_of(ErrorCode code) { return ErrorReply{std::string(name(code)), code}; }
inline ServerReply reply_of(WarningCode code) {
  return WarningReply{std::string(name(code)), code};
}

/// Parses any of these messages; errors name the byte. `(ok look ...)` is a GlobalView.
base::Result<void> parse(std::string_view message, ServerReply& out);

/// Appends the message like rcssserver 19; replies to team_names and recover end with a line feed.
/// ErrorReply and WarningReply are written from their text.
void format(const ServerReply& reply, std::string& out);

}  // namespace cls::soccer
