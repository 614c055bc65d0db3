// A 4-3-3 in the own half.
#include "training/tasks/formation.h"

#include <array>

namespace cls::training {

Vec2 kick_off_position(int slot) {
  // By uniform number. The last one stands at the circle, ready for the kick-off.
  static constexpr std::array<Vec2, soccer::kPlayersPerTeam> kPlaces = {{{-50.0, 0.0},
                                                                         {-35.0, -7.0},
                                                                         {-35.0, 7.0},
                                                                         {-33.0, -20.0},
                                                                         {-33.0, 20.0},
                                                                         {-20.0, 0.0},
                                                                         {-18.0, -11.0},
                                                                         {-18.0, 11.0},
                                                                         {-9.6, -20.0},
                                                                         {-9.6, 20.0},
                                                                         {-9.6, 0.0}}};

  const Vec2 place = kPlaces[static_cast<std::size_t>(soccer::unum_of_slot(slot) - 1)];
  return place * soccer::sign(soccer::side_of_slot(slot));
}

}  // namespace cls::training
