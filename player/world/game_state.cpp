// Play mode queries and the game clock of an agent.
#include "player/world/game_state.h"

#include <array>

namespace cls::player {

using soccer::PlayMode;
using soccer::Side;

bool clock_stopped(PlayMode mode) {
  const soccer::ModeClass kind = soccer::mode_class(mode);
  return kind == soccer::ModeClass::kWaiting || kind == soccer::ModeClass::kStopped;
}

bool is_set_play_of(const GameState& game, Side side) {
  if (soccer::is_set_play(game.mode)) return game.mode_side() == side;
  if (game.mode_side() == Side::kNeutral) return false;

  switch (soccer::for_side(game.mode, Side::kLeft)) {
    case PlayMode::kOffsideLeft:
    case PlayMode::kFoulChargeLeft:
    case PlayMode::kFoulPushLeft:
    case PlayMode::kFreeKickFaultLeft:
    case PlayMode::kBackPassLeft:
    case PlayMode::kCatchFaultLeft:
    case PlayMode::kIllegalDefenseLeft:
      return game.mode_side() == soccer::opponent(side);
    default:
      return false;
  }
}

void begin_step(GameState& game, int cycle) {
  const int before = cycle == game.time.cycle ? game.time.stopped : 0;
  game.time = {cycle, clock_stopped(game.mode) ? before + 1 : 0};
}

int default_penalty_taker(int n) {
  constexpr std::array<int, 11> kOrder = {10, 9, 2, 11, 3, 4, 1, 5, 6, 7, 8};
  return kOrder[static_cast<std::size_t>(n > 0 ? (n - 1) % 11 : 0)];
}

}  // namespace cls::player
