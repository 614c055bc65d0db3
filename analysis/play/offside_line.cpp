// The two opponents nearest to their goal.
#include "analysis/play/offside_line.h"

#include <algorithm>

#include "analysis/play/flow.h"

namespace cls::analysis {

double offside_line(const gamelog::MatchRecord& record, std::size_t frame,
                    std::size_t attacking_team) {
  const std::size_t defenders = attacking_team == 0 ? gamelog::kSlots / 2 : 0;
  const double sign = attacking_team == 0 ? 1.0 : -1.0;
  double last = 0.0;  // nobody behind the half line makes a difference
  double second = 0.0;
  for (std::size_t slot = defenders; slot < defenders + gamelog::kSlots / 2; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    if (!gamelog::is_enabled(record, entry)) continue;
    const double x = record.players.position[entry].x * sign;
    if (x > last) {
      second = last;
      last = x;
    } else {
      second = std::max(second, x);
    }
  }
  return std::max({second, 0.0, record.ball_position[frame].x * sign});
}

}  // namespace cls::analysis
