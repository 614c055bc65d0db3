// Turning changes of the world into goals and events.
#include "orchestration/match/hooks/match_chronicle.h"

#include <nlohmann/json.hpp>
#include <string>

#include "soccer/side_name.h"

namespace cls::orchestration::match {
namespace {

using Json = nlohmann::ordered_json;
using soccer::Side;

std::size_t index_of(Side side) { return side == Side::kRight ? 1 : 0; }

}  // namespace

void MatchChronicle::begin(const TeamNames& names, std::uint64_t seed) {
  events_.add(0, "started", {{"left", names.left}, {"right", names.right}, {"seed", seed}});
}

void MatchChronicle::note_kicks(const simulator::World& world) {
  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    const int kicks = world.players[slot].counters.kick;
    if (kicks == kicks_[slot]) continue;
    kicks_[slot] = kicks;
    const int number = static_cast<int>(slot);
    last_kicker_[index_of(soccer::side_of_slot(number))] = soccer::unum_of_slot(number);
  }
}

void MatchChronicle::note_goals(const simulator::World& world) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = index_of(side);
    const int score = world.team(side).score;
    if (score == scores_[i]) continue;
    scores_[i] = score;
    const Goal goal{world.clock.time, side, last_kicker_[i]};
    goals_.push_back(goal);
    events_.add(goal.cycle, "goal",
                {{"side", side_name(side)},
                 {"unum", goal.unum == 0 ? Json(nullptr) : Json(goal.unum)},
                 {"score", {scores_[0], scores_[1]}}});
    last_kicker_ = {};
  }
}

void MatchChronicle::follow(const simulator::World& world) {
  note_kicks(world);
  note_goals(world);
  if (world.mode == mode_) return;
  mode_ = world.mode;
  events_.add(world.clock.time, "play_mode", {{"mode", name(mode_)}});
}

void MatchChronicle::end(const MatchResult& result) {
  events_.add(result.cycles, "ended",
              {{"end_reason", name(result.end_reason)},
               {"score", {result.left.score, result.right.score}}});
}

}  // namespace cls::orchestration::match
