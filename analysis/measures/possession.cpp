// Counts frames by the team in possession.
#include "analysis/measures/possession.h"

#include "analysis/play/interception_time.h"

namespace cls::analysis {
namespace {

void count(std::int8_t slot, PerTeam<int>& frames) {
  if (slot != kNoPlayer) ++frames[team_of(slot)];
}

// Frames before a touch count for the toucher, back to the previous touch or the start of the live
// phase.
void count_next_kickers(const Flow& flow, Possession& result) {
  std::size_t touch = 0;
  for (std::size_t i = 0; i < flow.phase.size(); ++i) {
    if (!flow.is_live(i)) continue;
    while (touch < flow.touches.size() && flow.touches[touch].frame <= i) ++touch;
    if (touch == flow.touches.size()) return;
    const Touch& next = flow.touches[touch];
    if (next.live_phase == flow.live_phase[i]) count(next.slot, result.next_kicker);
  }
}

void count_at_feet(const gamelog::MatchRecord& record, std::size_t frame, Possession& result) {
  const soccer::Vec2 ball = record.ball_position[frame];
  PerTeam<bool> has = {};

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    const double radius = kickable_radius(record, entry);
    if (gamelog::is_enabled(record, entry) &&
        soccer::squared_distance(record.players.position[entry], ball) <= radius * radius) {
      has[team_of(slot)] = true;
    }
  }

  if (has[0] && has[1]) {
    ++result.at_feet_contested;
  } else if (has[0] || has[1]) {
    ++result.at_feet[has[0] ? 0 : 1];
  }
}

}  // namespace

Possession measure_possession(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  Possession result;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    if (flow.phase[i] == Phase::kSet) {
      const soccer::Side taker = soccer::side(record.mode[i]);
      if (taker != soccer::Side::kNeutral) ++result.all_play[team_of(taker)];
    }

    if (!flow.is_live(i)) continue;
    ++result.live_frames;
    count(flow.owner[i], result.last_touch);
    count(flow.owner[i], result.all_play);
    count_at_feet(record, i, result);
    const auto first = first_to_ball(record, i);
    if (first) ++result.fastest[team_of(first->slot)];
  }

  count_next_kickers(flow, result);
  return result;
}

double left_share(const PerTeam<int>& frames) {
  const int both = frames[0] + frames[1];
  return both == 0 ? 0.5 : static_cast<double>(frames[0]) / both;
}

}  // namespace cls::analysis
