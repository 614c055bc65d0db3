// Which neck angle shows most of what has not been seen for long.
#pragma once

#include <array>

#include "proxy/commands/command_slots.h"
#include "proxy/world/fixed_list.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Made once per decision and asked with ranges of neck angles (degrees off the next body).
class NeckSearch {
 public:
  NeckSearch(const WorldModel& world, const SightMemory& sight, const CommandSlots& slots);

  bool knows_all_players() const { return all_players_; }
  /// The angle in [low, high] in whose view the sum of ages over the pitch is largest.
  double best_field(double low, double high) const;
  /// The angle in [low, high] that shows the most and longest unseen players.
  double best_players(double low, double high) const;

 private:
  struct Sight {
    double relative;  ///< degrees off the next body
    double weight;
  };

  template <typename Score>
  double best(double low, double high, const Score& score) const;
  void add_players(const WorldModel& world, const PlayerList& list, soccer::Vec2 here, bool ours);
  double player_score(double neck) const;
  double field_score(double neck) const;

  double half_view_;
  double neck_now_;
  soccer::AngleDeg body_;
  bool all_players_ = false;
  FixedList<Sight, 44> players_;
  std::array<double, SightMemory::kSectors> field_;  ///< worth of each sector of directions
};

}  // namespace cls::proxy
