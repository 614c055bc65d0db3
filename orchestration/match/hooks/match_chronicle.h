// What happened on the pitch, read off the world cycle by cycle: goals, modes, the events file.
#pragma once

#include <array>
#include <vector>

#include "orchestration/match/options/endpoint.h"
#include "orchestration/match/result/event_log.h"
#include "orchestration/match/result/match_result.h"
#include "simulator/world/world.h"

namespace cls::orchestration::match {

/// Follows one match. Depends on the world only, so the events file repeats with the seed.
class MatchChronicle {
 public:
  /// `events` must outlive the chronicle.
  explicit MatchChronicle(EventLog& events) : events_(events) {}

  void begin(const TeamNames& names, std::uint64_t seed);
  /// After every step.
  void follow(const simulator::World& world);
  void end(const MatchResult& result);

  const std::vector<Goal>& goals() const { return goals_; }

 private:
  void note_kicks(const simulator::World& world);
  void note_goals(const simulator::World& world);

  EventLog& events_;
  std::vector<Goal> goals_;
  std::array<int, soccer::kPlayersOnPitch> kicks_{};
  std::array<int, 2> last_kicker_{};  ///< unum by team; 0: none since the last goal
  std::array<int, 2> scores_{};
  soccer::PlayMode mode_ = soccer::PlayMode::kNull;
};

}  // namespace cls::orchestration::match
