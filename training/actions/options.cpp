// Action set "options": the choices of a field player in open play (player/options).
#include "player/options/option_ids.h"
#include "training/actions/family.h"

namespace cls::training {

const ActionSet& option_actions() {
  static const ActionSet set = [] {
    ActionSet all = {
        .name = "options",
        .summary =
            "world model only: shoot, hold, lay off, clear, 16 dribbles and 40 passes with the "
            "ball, 23 moves without it, auto; where a player of cls has nothing to choose, it "
            "plays "
            "by itself",
        .options = true};
    for (int id = 0; id < player::kOptionCount; ++id) {
      all.actions.push_back({stored(player::option_name(id)), {}, nullptr});
    }
    return all;
  }();
  return set;
}

}  // namespace cls::training
