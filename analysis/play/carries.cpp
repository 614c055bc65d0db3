// Finds carries: consecutive touches of one player.
#include "analysis/play/carries.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kMinDribble = 1.0;
constexpr double kMaxDistanceInFront = 3.0;

int opponents_passed(const gamelog::MatchRecord& record, const Carry& carry, std::size_t first,
                     std::size_t last) {
  const double sign = attack_sign(carry.slot);
  int passed = 0;

  for (const std::size_t other : kTeamSlots[1 - team_of(carry.slot)]) {
    const std::size_t entry = entry_of(first, other);
    if (!gamelog::is_enabled(record, entry)) continue;
    const Vec2 before = Vec2(record.players.position[entry]) * sign;
    const double dx = before.x - carry.from.x;
    const bool in_front = dx >= 0.0 && soccer::distance(before, carry.from) <= kMaxDistanceInFront;
    const double now_x = record.players.position[entry_of(last, other)].x * sign;
    passed += in_front && now_x < carry.to.x;
  }
  return passed;
}

}  // namespace

std::vector<Carry> find_carries(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  std::vector<Carry> carries;
  for (std::size_t i = 0; i + 1 < flow.touches.size(); ++i) {
    const Touch& touch = flow.touches[i];
    const Touch& next = flow.touches[i + 1];
    if (touch.contested() || touch.slot != next.slot || touch.live_phase < 0 ||
        touch.live_phase != next.live_phase) {
      continue;
    }

    const auto slot = slot_index(touch.slot);
    const double sign = attack_sign(slot);

    Carry carry = {.touch = static_cast<std::uint32_t>(i),
                   .slot = touch.slot,
                   .from = touch.contact * sign,
                   .to = next.contact * sign};

    // Versions 1 and 2 have no dash counter.
    const std::size_t last = next.frame - 1;
    const bool ran = record.version < gamelog::RcgVersion::kV3 ||
                     has_executed(record, gamelog::Counter::kDash, entry_of(touch.frame, slot),
                                  entry_of(last, slot));
    carry.dribble = ran && carry.distance() >= kMinDribble;
    carry.passed = opponents_passed(record, carry, touch.frame - 1, last);

    carries.push_back(carry);
  }
  return carries;
}

}  // namespace cls::analysis
