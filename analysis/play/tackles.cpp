// Counts tackles in their first frame.
#include "analysis/play/tackles.h"

namespace cls::analysis {
namespace {

constexpr std::uint32_t kTackleBits = gamelog::kStateTackle | gamelog::kStateTackleFailed;

bool begins(const gamelog::MatchRecord& record, std::size_t entry) {
  const std::size_t before = entry - gamelog::kSlots;
  if ((record.players.state[before] & gamelog::kStateEnabled) == 0) return false;
  if (record.version >= gamelog::RcgVersion::kV4) {
    return has_executed(record, gamelog::Counter::kTackle, entry);
  }
  return (record.players.state[entry] & kTackleBits) != 0 &&
         (record.players.state[before] & kTackleBits) == 0;
}

void classify_hits(const Flow& flow, PerPlayer<Tackles>& tackles) {
  for (std::size_t i = 0; i < flow.touches.size(); ++i) {
    const Touch& touch = flow.touches[i];
    if (touch.kind != TouchKind::kTackle || touch.contested()) continue;

    const auto slot = slot_index(touch.slot);
    const std::int8_t owner = flow.owner[touch.frame - 1];
    if (owner == kNoPlayer) continue;
    if (same_team(owner, slot)) {
      ++tackles[slot].as_kick;
      continue;
    }

    std::size_t next = i + 1;
    while (next < flow.touches.size() && flow.touches[next].contested()) ++next;
    if (next < flow.touches.size() && same_team(flow.touches[next].slot, slot)) {
      ++tackles[slot].effective;
    }
  }
}

}  // namespace

PerPlayer<Tackles> count_tackles(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  PerPlayer<Tackles> tackles;

  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (flow.phase[i] == Phase::kPenalty || record.time[i] < record.time[i - 1]) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      if (!begins(record, entry)) continue;
      const std::uint32_t bits = record.players.state[entry] & kTackleBits;

      ++tackles[slot].tried;
      tackles[slot].succeeded += bits == gamelog::kStateTackle;
      tackles[slot].failed += bits == kTackleBits;
      tackles[slot].out_of_reach += bits == gamelog::kStateTackleFailed;
    }
  }

  classify_hits(flow, tackles);
  return tackles;
}

}  // namespace cls::analysis
