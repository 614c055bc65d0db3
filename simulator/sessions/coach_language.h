// What an online coach may say, how much of it, and when its players hear it (protocol 5.4).
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

/// The quotas and the queue of one team's coach. They outlive its connection.
class CoachLanguage {
 public:
  struct Words {
    soccer::CoachSay said;
    int received = 0;  ///< game time
  };

  explicit CoachLanguage(const soccer::ServerParams& params)
      : freeform_allowed_(params.say_coach_cnt_max) {}

  /// Takes the words into the queue, or says why not.
  std::optional<soccer::ErrorCode> say(const World& world, const soccer::CoachSay& said);

  /// At the beginning of each step: appends to `out` what is heard now, oldest first, and renews
  /// the quotas when a window is over.
  void begin_step(const World& world, std::vector<Words>& out);

  /// At the end of each full game time: say_coach_cnt_max more freeform messages.
  void award(const soccer::ServerParams& params);

 private:
  static constexpr std::size_t kKinds = static_cast<std::size_t>(soccer::ClangKind::kDelete) + 1;

  std::deque<Words> queue_;
  int freeform_said_ = 0;
  int freeform_allowed_;               ///< negative: any number
  std::array<int, kKinds> left_ = {};  ///< in this window of play_on, by ClangKind
  std::optional<int> window_start_;    ///< game time
};

/// True if a player that has declared `versions` understands words of that kind; players that have
/// not declared any get a note instead.
bool understands(const soccer::Clang& versions, soccer::ClangKind kind);

}  // namespace cls::simulator
