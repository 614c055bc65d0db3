// All passes, carries, shots, tackles, fouls and goals of a match in one list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

enum class EventKind : std::uint8_t { kPass, kCarry, kShot, kTackle, kFoul, kGoal };
/// "pass", "carry", "shot", "tackle", "foul", "goal".
std::string_view name(EventKind kind);

/// An event. Points as the left team sees the pitch.
struct Event {
  EventKind kind = EventKind::kPass;
  /// Which one of the passes, carries, shots, fouls or goals of the statistics; of a tackle which
  /// of the touches.
  std::size_t index = 0;
  std::uint32_t frame = 0;
  std::int32_t cycle = 0;
  std::int32_t stopped = 0;
  std::int8_t slot = kNoPlayer;
  std::int8_t other = kNoPlayer;  ///< slot of receiver, interceptor or victim
  soccer::Vec2 from;
  soccer::Vec2 to;
  std::string_view result;  ///< a text; what it says is in the statistics, too
  /// Properties of a pass: "through", "cross", "switch", "cutback", "clearance".
  std::vector<std::string_view> marks;
};

/// Sorted by frame.
std::vector<Event> list_events(const MatchStatistics& statistics);

}  // namespace cls::analysis
