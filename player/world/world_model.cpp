// Queries of a world model, and the game clock of an agent.
#include "player/world/world_model.h"

#include <algorithm>
#include <array>

#include "base/index.h"
#include "player/world/planner_parameters.h"

namespace cls::player {
namespace {

const PlayerState* find(const PlayerList& list, int PlayerState::*member, int value) {
  const PlayerState* found = std::ranges::find(list, value, member);
  return found == list.end() ? nullptr : found;
}

}  // namespace

// All agents begin with the same defaults, whose tables take a while to make.
WorldModel::WorldModel() : formations(built_in_formations()) {
  static const auto default_parameters = std::make_shared<const MatchParameters>();
  static const auto default_planner = std::make_shared<const PlannerParameters>();
  parameters = default_parameters;
  planner = default_planner;
}

const PlayerState* WorldModel::teammate(int number) const {
  return find(teammates, &PlayerState::unum, number);
}

const PlayerState* WorldModel::opponent(int number) const {
  return find(opponents, &PlayerState::unum, number);
}

const PlayerState* WorldModel::player_by_id(int id) const {
  for (const PlayerList* list : {&teammates, &opponents, &unknowns}) {
    if (const PlayerState* player = find(*list, &PlayerState::id, id)) return player;
  }
  return nullptr;
}

bool before_play(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || without_side(mode) == PlayMode::kGoalLeft;
}

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
  return kOrder[base::index(n > 0 ? (n - 1) % 11 : 0)];
}

}  // namespace cls::player
