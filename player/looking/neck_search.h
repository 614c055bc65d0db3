// Search for the neck angle that shows what was unseen for longest.
#pragma once

#include <array>

#include "base/fixed_list.h"
#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Sums of the values of the direction sectors before each one, twice around.
using SectorSums = std::array<int, 2 * ViewMemory::kSectors + 1>;
SectorSums sector_sums(const std::array<int, ViewMemory::kSectors>& values);

/// Sum of the values of a range of sectors.
inline int sum_of(const SectorSums& sums, SectorRange range) {
  return sums[range.first + range.count] - sums[range.first];
}

/// Searches ranges of neck angles, degrees relative to the next body. What a search needs of the
/// world is computed by it: most decisions need one. The arguments must outlive the object.
class NeckSearch {
 public:
  NeckSearch(const WorldModel& world, const ViewMemory& view, const CommandSlots& slots);

  bool knows_all_players() const;
  /// Angle in [low, high] with the largest sum of direction ages over the pitch.
  double best_field(double low, double high) const;
  /// Angle in [low, high] that shows the most and longest unseen players.
  double best_players(double low, double high) const;

 private:
  struct WeightedDirection {
    double relative;  ///< degrees relative to the next body
    double weight;
  };
  using WeightedDirections = base::FixedList<WeightedDirection, 2 * PlayerList::capacity()>;

  template <typename Score>
  double best(double low, double high, const Score& score) const;
  SectorSums field_sums() const;
  void add_players(const PlayerList& list, bool ours, WeightedDirections& out) const;
  double player_score(const WeightedDirections& players, double neck) const;

  const WorldModel& world_;
  const ViewMemory& view_;
  Vec2 here_;  ///< in the next cycle
  double half_view_;
  double neck_now_;
  AngleDeg body_;
};

}  // namespace cls::player
