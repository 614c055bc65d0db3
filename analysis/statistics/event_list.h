// Passes, carries, shots, tackles, fouls and goals of a match in one list.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

/// Points as the left team sees the pitch, whoever acts.
struct Event {
  std::uint32_t frame = 0;
  std::int32_t cycle = 0;
  std::int32_t stopped = 0;
  std::string_view kind;  ///< "pass", "carry", "shot", "tackle", "foul", "goal"
  std::int8_t slot = kNobody;
  soccer::Vec2 from;
  soccer::Vec2 to;
  std::int8_t other = kNobody;  ///< slot of the receiver, the interceptor, the victim
  std::string_view result;
  std::int32_t pass = -1;  ///< index into MatchStatistics::passes, for passes
  /// What else a pass was: "through", "cross", "switch", "cutback", "clearance".
  std::vector<std::string_view> marks;
};

/// By frame.
std::vector<Event> events_of(const MatchStatistics& statistics);

}  // namespace cls::analysis
