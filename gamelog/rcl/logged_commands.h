// The commands in a logged datagram, cut apart quickly and told by kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cls::gamelog {

/// What a player, coach or trainer asked for. kOther: not a command of the player grammar.
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

/// Of these the first one in a cycle counts, the others are ignored by the server.
bool is_body_command(CommandKind kind);

struct LoggedCommand {
  CommandKind kind = CommandKind::kOther;
  std::string_view arguments;  ///< between name and closing bracket, without the blank before
};

/// Goes through the bracketed expressions of a datagram. Quoted texts hide brackets; a say without
/// quotes reaches to the last bracket it can, as in the server. What stands outside of brackets is
/// skipped, an expression without its closing bracket ends the datagram.
class CommandCursor {
 public:
  explicit CommandCursor(std::string_view datagram) : rest_(datagram) {}

  bool next(LoggedCommand& command);

 private:
  std::string_view rest_;
};

}  // namespace cls::gamelog
