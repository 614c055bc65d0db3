// The flow of play: phases, touches of the ball and whose ball it is. The base of all statistics.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "analysis/play/phase.h"
#include "gamelog/record/match_record.h"
#include "soccer/geometry.h"

namespace cls::analysis {

constexpr std::int8_t kNobody = -1;

enum class TouchKind : std::uint8_t {
  kKick,
  kTackle,  ///< one that reached the ball
  kCatch,
  kPunch,  ///< a catch that failed by chance: the ball is deflected
};

/// The ball was played between frame - 1 and frame, by one player or by several at once.
struct Touch {
  std::uint32_t frame = 0;
  /// Who: of several players of one team the nearest; kNobody when both teams touched it.
  std::int8_t slot = kNobody;
  TouchKind kind = TouchKind::kKick;
  std::uint32_t touchers = 0;  ///< bit per slot
  /// The nearest toucher of each team, for contested touches.
  std::array<std::int8_t, 2> nearest = {kNobody, kNobody};
  soccer::Vec2 contact;  ///< where the ball was
  soccer::Vec2 launch;   ///< its displacement in the step, which is its new velocity
  /// Number of the live phase that the touch starts, belongs to or ends; -1: none.
  std::int32_t live_phase = -1;

  bool contested() const { return slot == kNobody; }
};

/// Derived from a record, which must outlive it.
struct Flow {
  const gamelog::MatchRecord* record = nullptr;

  // One entry a frame.
  std::vector<Phase> phase;
  /// Number of the run of live frames, from 0; -1 elsewhere. A ball that was put somewhere while
  /// play went on (a dropped ball) starts a new one.
  std::vector<std::int32_t> live_phase;
  std::vector<std::int8_t> owner;  ///< last toucher within the live phase

  std::vector<Touch> touches;         ///< of all phases, by frame
  std::vector<std::uint32_t> placed;  ///< live frames in which the ball was dropped or moved

  bool is_live(std::size_t frame) const { return phase[frame] == Phase::kLive; }

  /// The first frame behind a touch that is not of the touch's live phase any more; the number of
  /// frames if there is none. The touch must have a live phase.
  std::size_t end_of_play(const Touch& touch) const;
};

Flow flow_of(const gamelog::MatchRecord& record);

// --- small things that all statistics need ---

inline std::size_t entry_of(std::size_t frame, std::size_t slot) {
  return frame * gamelog::kSlots + slot;
}

/// +1 for left, -1 for right: multiplying a position makes its team attack +x.
inline double attack_sign(std::size_t slot) { return slot < gamelog::kSlots / 2 ? 1.0 : -1.0; }
inline std::size_t team_of(std::size_t slot) { return slot < gamelog::kSlots / 2 ? 0 : 1; }
inline bool same_team(std::size_t a, std::size_t b) { return team_of(a) == team_of(b); }

/// One value for the left team, one for the right.
template <typename T>
using PerTeam = std::array<T, 2>;
template <typename T>
using PerPlayer = std::array<T, gamelog::kSlots>;

/// The player type of a slot in a frame; type 0 of the record's parameters if the log has none.
const soccer::PlayerType& type_of(const gamelog::MatchRecord& record, std::size_t entry);

/// Distance of centres within which this player can kick.
double kickable_radius(const gamelog::MatchRecord& record, std::size_t entry);

inline bool is_goalie(const gamelog::MatchRecord& record, std::size_t entry) {
  return (record.players.state[entry] & gamelog::kStateGoalie) != 0;
}

}  // namespace cls::analysis
