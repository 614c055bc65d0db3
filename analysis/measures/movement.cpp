// Adding up steps.
#include "analysis/measures/movement.h"

#include <algorithm>

namespace cls::analysis {
namespace {

constexpr double kLongestStep = 1.5;
constexpr std::array<double, kSpeedBandCount - 1> kBandLimits = {0.2, 0.6, 0.85};

std::size_t band_of(double share) {
  std::size_t band = 0;
  while (band < kBandLimits.size() && share >= kBandLimits[band]) ++band;
  return band;
}

}  // namespace

PerPlayer<Movement> movement_of(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  PerPlayer<Movement> result;
  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (record.time[i] < record.time[i - 1]) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      if (!gamelog::is_enabled(record, entry) ||
          !gamelog::is_enabled(record, entry - gamelog::kSlots))
        continue;
      const double step = soccer::distance(record.players.position[entry],
                                           record.players.position[entry - gamelog::kSlots]);
      const double top_speed = type_of(record, entry).player_speed_max;
      if (step > kLongestStep * top_speed) continue;
      Movement& player = result[slot];
      if (!flow.is_live(i)) {
        player.other_distance += step;
        continue;
      }
      player.live_distance += step;
      player.top_speed = std::max(player.top_speed, step);
      ++player.bands[band_of(step / top_speed)];
    }
  }
  return result;
}

}  // namespace cls::analysis
