// Splits a logged datagram into commands and their kinds. Faster than the protocol's parser,
// because statistics read every datagram of a match.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cls::gamelog {

/// Commands of players, coaches and trainers. kOther: not a command of the player grammar.
enum class CommandKind : std::uint8_t {
  kDash,
  kTurn,
  kTurnNeck,
  kKick,
  kLongKick,
  kTackle,
  kCatch,
  kMove,
  kChangeView,
  kChangeFocus,
  kSay,
  kPointto,
  kAttentionto,
  kEar,
  kClang,
  kCompression,
  kSynchSee,
  kGaussianSee,
  kScore,
  kSenseBody,
  kDone,
  kBye,
  kInit,
  kReconnect,
  kOther,
};
constexpr std::size_t kCommandKindCount = static_cast<std::size_t>(CommandKind::kOther) + 1;

/// "dash", "turn", ...; "other" for kOther.
std::string_view name(CommandKind kind);

/// Body commands: the server executes only the first of a cycle.
bool is_body_command(CommandKind kind);

struct LoggedCommand {
  CommandKind kind = CommandKind::kOther;
  std::string_view arguments;  ///< between the name's space and the closing bracket
};

/// Iterates over the bracketed expressions of a datagram. Brackets in quoted text do not count; a
/// say without quotes extends to its last bracket, as in rcssserver. Text outside brackets is
/// skipped. An expression without its closing bracket ends the datagram.
class CommandCursor {
 public:
  explicit CommandCursor(std::string_view datagram) : rest_(datagram) {}

  bool next(LoggedCommand& command);

 private:
  std::string_view rest_;
};

}  // namespace cls::gamelog
