// Search for the neck angle that shows what was unseen for longest.
#pragma once

#include <array>

#include "base/fixed_list.h"
#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Created once per decision; searches ranges of neck angles, degrees relative to the next body.
class NeckSearch {
 public:
  NeckSearch(const WorldModel& world, const ViewMemory& view, const CommandSlots& slots);

  bool knows_all_players() const { return all_players_; }
  /// Angle in [low, high] with the largest sum of direction ages over the pitch.
  double best_field(double low, double high) const;
  /// Angle in [low, high] that shows the most and longest unseen players.
  double best_players(double low, double high) const;

 private:
  struct WeightedDirection {
    double relative;  ///< degrees relative to the next body
    double weight;
  };

  template <typename Score>
  double best(double low, double high, const Score& score) const;
  void add_players(const WorldModel& world, const PlayerList& list, Vec2 here, bool ours);
  double player_score(double neck) const;
  double field_score(double neck) const;

  double half_view_;
  double neck_now_;
  AngleDeg body_;
  bool all_players_ = false;
  base::FixedList<WeightedDirection, 44> players_;
  /// Sum of the scores of the direction sectors before each one, twice around.
  std::array<int, 2 * ViewMemory::kSectors + 1> field_before_{};
};

}  // namespace cls::player
