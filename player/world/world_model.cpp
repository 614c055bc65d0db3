// Lookups in a world model.
#include "player/world/world_model.h"

#include <algorithm>

#include "player/world/planner_parameters.h"

namespace cls::player {
namespace {

template <typename Predicate>
const PlayerState* find(const PlayerList& list, Predicate predicate) {
  const PlayerState* found = std::find_if(list.begin(), list.end(), predicate);
  return found == list.end() ? nullptr : found;
}

}  // namespace

WorldModel::WorldModel()
    : parameters(std::make_shared<const MatchParameters>()),
      formations(built_in_formations()),
      planner(std::make_shared<const PlannerParameters>()) {}

const PlayerState* WorldModel::teammate(int number) const {
  return find(teammates, [number](const PlayerState& p) { return p.unum == number; });
}

const PlayerState* WorldModel::opponent(int number) const {
  return find(opponents, [number](const PlayerState& p) { return p.unum == number; });
}

const PlayerState* WorldModel::player_by_id(int id) const {
  for (const PlayerList* list : {&teammates, &opponents, &unknowns}) {
    const PlayerState* player = find(*list, [id](const PlayerState& p) { return p.id == id; });
    if (player != nullptr) return player;
  }
  return nullptr;
}

}  // namespace cls::player
