// First tokens of server messages.
#include "soccer/protocol/message_kind.h"

#include <array>

namespace cls::soccer {

MessageKind message_kind(std::string_view message) {
  struct Start {
    std::string_view text;
    MessageKind kind;
  };
  // Frequent messages first; "(ok look " before "(ok ".
  constexpr std::array kStarts = std::to_array<Start>({
      {"(see ", MessageKind::kSee},
      {"(sense_body ", MessageKind::kSenseBody},
      {"(think)", MessageKind::kReply},
      {"(hear ", MessageKind::kHear},
      {"(see_global ", MessageKind::kGlobalView},
      {"(fullstate ", MessageKind::kFullState},
      {"(ok look ", MessageKind::kGlobalView},
      {"(ok ", MessageKind::kReply},
      {"(change_player_type ", MessageKind::kReply},
      {"(error ", MessageKind::kReply},
      {"(warning ", MessageKind::kReply},
      {"(score ", MessageKind::kReply},
      {"(init ", MessageKind::kReply},
      {"(reconnect ", MessageKind::kReply},
      {"(clang ", MessageKind::kReply},
      {"(include ", MessageKind::kReply},
      {"(server_param ", MessageKind::kServerParam},
      {"(player_param ", MessageKind::kPlayerParam},
      {"(player_type ", MessageKind::kPlayerType},
  });
  for (const Start& start : kStarts) {
    if (message.starts_with(start.text)) return start.kind;
  }
  return MessageKind::kUnknown;
}

}  // namespace cls::soccer
