// Commands of online coaches and trainers: one struct per command.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "soccer/commands/player_command.h"
#include "soccer/geometry.h"
#include "soccer/play_mode.h"
#include "soccer/protocol/reply_code.h"

namespace cls::soccer {

struct Look {};
struct Eye {
  bool on = true;
};
/// Trainer only.
struct TrainerEar {
  bool on = true;
};
struct RequestTeamNames {};
struct CheckBall {};

/// Online coach: `(change_player_type UNUM TYPE)`; without a type: the goalie form.
struct ChangePlayerType {
  int unum = 0;
  std::optional<int> type;
};
/// Trainer: `(change_player_type TEAM UNUM TYPE)`.
struct TrainerChangePlayerType {
  std::string team;
  int unum = 0;
  int type = 0;
};

enum class ClangKind : std::uint8_t { kFreeform, kInfo, kAdvice, kDefine, kMeta, kRule, kDelete };

/// Online coach: `(say MSG)` with MSG in the coach language. `text` is MSG with parentheses, for
/// example `(freeform "hello")`; for kinds other than freeform only the outer form is checked.
struct CoachSay {
  ClangKind kind = ClangKind::kFreeform;
  std::string text;

  /// The text of a freeform message, without quotes; empty for other kinds.
  std::string_view freeform() const;
};
/// Trainer: `(say MSG)` with plain text; the server truncates it to say_coach_msg_size.
struct TrainerSay {
  std::string text;
};

/// `(team_graphic (X Y "..." "..." ...))`: an XPM tile, header line first, lines without quotes.
struct TeamGraphic {
  int x = 0;
  int y = 0;
  std::vector<std::string> xpm;
};

struct Start {};
struct ChangeMode {
  PlayMode mode = PlayMode::kPlayOn;
};
/// `(move (ball) X Y [ANG [VX VY]])`. The angle has no effect on a ball.
struct MoveBall {
  Vec2 position;
  std::optional<double> angle;
  std::optional<Vec2> velocity;
};
/// The server reads at most so many characters of the object of a `(move ...)`.
inline constexpr std::size_t kMaxMoveObjectSize = 127;

/// `(move (player TEAM UNUM) X Y [ANG [VX VY]])`, global coordinates and degrees. A velocity
/// comes only together with an angle.
struct MovePlayer {
  std::string team;
  int unum = 0;
  Vec2 position;
  std::optional<double> angle;
  std::optional<Vec2> velocity;
};
struct Recover {};

/// Done, Bye and Compression are shared with players. A trainer has no Bye.
using CoachCommand =
    std::variant<Look, Eye, TrainerEar, RequestTeamNames, CheckBall, ChangePlayerType,
                 TrainerChangePlayerType, CoachSay, TrainerSay, TeamGraphic, Start, ChangeMode,
                 MoveBall, MovePlayer, Recover, Done, Bye, Compression>;

enum class CoachRole : std::uint8_t { kOnlineCoach, kTrainer };

/// Parses the first command of a datagram and ignores the rest, like rcssserver, except that the
/// say command of an online coach must be the whole datagram. Returns the error reply, or nothing.
std::optional<ErrorCode> parse(std::string_view datagram, CoachRole role, CoachCommand& out);

/// Appends the command, with numbers in the shortest form that parses to the same value. False,
/// appending nothing, for numbers that are not finite and texts that the server would reject.
[[nodiscard]] bool format(const CoachCommand& command, std::string& out);

}  // namespace cls::soccer
