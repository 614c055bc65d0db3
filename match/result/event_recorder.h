// Writer of events.jsonl (`cls.events/1`): one JSON object a line for start, play modes, goals,
// end.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/io/byte_sink.h"
#include "base/text/json.h"
#include "gamelog/record/match_record.h"
#include "match/result/match_result.h"
#include "match/terms/endpoint.h"
#include "simulator/world/world.h"

namespace cls::match {

/// Writes lines {"schema": "cls.events/1", "seq": n, "t": game time, "type": ...}. `t` is game
/// time in cycles, never wall time: the same seed gives the same bytes.
class EventRecorder {
 public:
  /// `sink` must outlive the recorder.
  explicit EventRecorder(base::ByteSink& sink) : sink_(sink) {}

  void start(const TeamNames& names, std::uint64_t seed);
  /// Records what changed since the last step of the embedded server. Call after every step.
  void follow(const simulator::World& world);
  /// Records the play modes of a game log and the goals of `result`, in the order of time.
  void read_log(const gamelog::MatchRecord& log, const MatchResult& result);
  void end(const MatchResult& result);

  const std::vector<Goal>& goals() const { return goals_; }

 private:
  void add(int time, std::string_view type, const base::Json& fields);
  void add_goal(const Goal& goal);
  void add_play_mode(int time, soccer::PlayMode mode);
  void follow_kicks(const simulator::World& world);
  void follow_goals(const simulator::World& world);

  base::ByteSink& sink_;
  std::int64_t next_ = 0;
  std::vector<Goal> goals_;
  std::array<int, 2> scores_{};
  std::array<int, soccer::kPlayersOnPitch> kicks_{};
  std::array<int, 2> last_kicker_{};  ///< unum by team; 0: none since the last goal
  soccer::PlayMode mode_ = soccer::PlayMode::kNull;
};

}  // namespace cls::match
