// All passes, carries, shots, tackles, fouls and goals of a match in one list.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

/// An event. Points as the left team sees the pitch.
struct Event {
  std::uint32_t frame = 0;
  std::int32_t cycle = 0;
  std::int32_t stopped = 0;
  std::string_view kind;  ///< "pass", "carry", "shot", "tackle", "foul", "goal"
  std::int8_t slot = kNoPlayer;
  soccer::Vec2 from;
  soccer::Vec2 to;
  std::int8_t other = kNoPlayer;  ///< slot of receiver, interceptor or victim
  std::string_view result;
  std::int32_t pass = -1;  ///< index into MatchStatistics::passes; -1: not a pass
  /// Properties of a pass: "through", "cross", "switch", "cutback", "clearance".
  std::vector<std::string_view> marks;
};

/// Sorted by frame.
std::vector<Event> list_events(const MatchStatistics& statistics);

}  // namespace cls::analysis
