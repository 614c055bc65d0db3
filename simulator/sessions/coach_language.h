// Coach language: quotas of an online coach and delays of its messages
// (docs/spec/server-protocol.md 5.4).
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "simulator/world/world.h"
#include "soccer/commands/coach_command.h"
#include "soccer/protocol/reply_code.h"

namespace cls::simulator {

/// Quotas and message queue of one team's coach. They outlive its connection.
class CoachLanguage {
 public:
  struct Message {
    soccer::CoachSay say;
    int received = 0;  ///< game time
  };

  explicit CoachLanguage(const soccer::ServerParams& params)
      : freeform_allowed_(params.say_coach_cnt_max) {}

  /// Queues the message, or returns why it is refused.
  std::optional<soccer::ErrorCode> say(const World& world, const soccer::CoachSay& message);

  /// At the beginning of each step: appends the messages that are due to `out`, oldest first, and
  /// resets the quotas when a window ends.
  void begin_step(const World& world, std::vector<Message>& out);

  /// At the end of each full game time: allows say_coach_cnt_max more freeform messages.
  void extend_freeform_quota(const soccer::ServerParams& params);

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(soccer::ClangKind::kDelete) + 1;

  std::deque<Message> queue_;
  int freeform_said_ = 0;
  int freeform_allowed_;               ///< negative: any number
  std::array<int, kKinds> left_ = {};  ///< quota left in this window of play_on, by ClangKind
  std::optional<int> window_start_;    ///< game time
};

/// True if a player that has declared `versions` understands messages of that kind.
bool understands(const soccer::Clang& versions, soccer::ClangKind kind);

}  // namespace cls::simulator
