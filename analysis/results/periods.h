// Halves, extra halves and the shoot-out of a match.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gamelog/record/match_record.h"

namespace cls::analysis {

enum class PeriodKind : std::uint8_t {
  kFirstHalf = 1,
  kSecondHalf,
  kFirstExtraHalf,
  kSecondExtraHalf,
  kShootOut,
};

/// Consecutive frames. Further halves of unusual rules count as the second half of their kind.
struct Period {
  PeriodKind kind = PeriodKind::kFirstHalf;
  std::size_t first_frame = 0;
  std::size_t end_frame = 0;  ///< behind the last
  int start_cycle = 0;        ///< game time at which the period began
};

/// In the order of the match; every frame is in one of them. The frame of cycle 3000, with usual
/// rules, is the last of the first half. A shoot-out begins with its first play mode.
std::vector<Period> find_periods(const gamelog::MatchRecord& record);

/// The period of a frame; there must be one.
const Period& period_of(const std::vector<Period>& periods, std::size_t frame);

/// Seconds of a cycle: 0.1 with usual rules.
double cycle_seconds(const soccer::ServerParams& server);

}  // namespace cls::analysis
