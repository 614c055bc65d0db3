// Two teammates at one ball, who kick it in turn.
#pragma once

#include "analysis/play/flow.h"
#include "soccer/geometry.h"

namespace cls::analysis {

/// Meters between two touches from which on the ball was played.
inline constexpr double kPlayedDistance = 3.0;

/// Whether the second of two successive touches is by a teammate who could kick the ball at the
/// first one already, with less than kPlayedDistance in between. The first touch is then not a
/// pass.
inline bool at_one_ball(const Flow& flow, const Touch& first, const Touch& second) {
  if (first.contested() || second.contested() || first.slot == second.slot ||
      !same_team(first.slot, second.slot) ||
      soccer::distance(first.contact, second.contact) >= kPlayedDistance) {
    return false;
  }

  const gamelog::MatchRecord& record = *flow.record;
  const std::size_t entry = entry_of(first.frame - 1, slot_index(second.slot));
  const soccer::Vec2 place = record.players.position[entry];
  return gamelog::is_enabled(record, entry) &&
         soccer::distance(place, first.contact) <= kickable_radius(record, entry);
}

}  // namespace cls::analysis
