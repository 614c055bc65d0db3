// Pairs of touches by the same player.
#include "analysis/play/carries.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kShortestDribble = 1.0;
constexpr double kInFront = 3.0;
constexpr std::size_t kDash = static_cast<std::size_t>(gamelog::Counter::kDash);

int opponents_passed(const gamelog::MatchRecord& record, const Carry& carry, std::size_t first,
                     std::size_t last) {
  const auto slot = static_cast<std::size_t>(carry.slot);
  const double sign = attack_sign(slot);
  const std::size_t opponents = team_of(slot) == 0 ? gamelog::kSlots / 2 : 0;
  int passed = 0;
  for (std::size_t other = opponents; other < opponents + gamelog::kSlots / 2; ++other) {
    const std::size_t entry = entry_of(first, other);
    if (!gamelog::is_enabled(record, entry)) continue;
    const Vec2 before = Vec2(record.players.position[entry]) * sign;
    const double dx = before.x - carry.from.x;
    const bool in_front = dx >= 0.0 && soccer::distance(before, carry.from) <= kInFront;
    const double now_x = record.players.position[entry_of(last, other)].x * sign;
    passed += in_front && now_x < carry.to.x;
  }
  return passed;
}

}  // namespace

std::vector<Carry> carries_of(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  std::vector<Carry> carries;
  for (std::size_t i = 0; i + 1 < flow.touches.size(); ++i) {
    const Touch& touch = flow.touches[i];
    const Touch& next = flow.touches[i + 1];
    if (touch.contested() || touch.slot != next.slot || touch.live_phase < 0 ||
        touch.live_phase != next.live_phase) {
      continue;
    }
    const auto slot = static_cast<std::size_t>(touch.slot);
    const double sign = attack_sign(slot);
    Carry carry;
    carry.touch = static_cast<std::uint32_t>(i);
    carry.slot = touch.slot;
    carry.from = touch.contact * sign;
    carry.to = next.contact * sign;
    const std::size_t last = next.frame - 1;
    const auto dashes = [&](std::size_t frame) {
      return record.players.counters[entry_of(frame, slot)][kDash];
    };
    // Versions 1 and 2 do not count dashes.
    const bool ran =
        record.version < gamelog::RcgVersion::kV3 || dashes(last) > dashes(touch.frame);
    carry.dribble = ran && carry.distance() >= kShortestDribble;
    carry.passed = opponents_passed(record, carry, touch.frame - 1, last);
    carries.push_back(carry);
  }
  return carries;
}

}  // namespace cls::analysis
