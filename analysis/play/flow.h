// Phases, touches and ball ownership: the basis of all statistics.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

#include "base/index.h"
#include "gamelog/record/match_record.h"
#include "soccer/geometry.h"
#include "soccer/per_side.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::analysis {

using soccer::kNoPlayer;

/// Kind of play of a frame. Statistics count kLive unless they say otherwise
/// (docs/spec/match-statistics.md 1.1).
enum class Phase : std::uint8_t {
  kLive,     ///< play_on
  kSet,      ///< a team may restart play; the clock runs
  kStopped,  ///< after a goal or an offense, before kick-off, pauses
  kPenalty,  ///< shoot-out
  kOver,
};
Phase phase_of(soccer::PlayMode mode);

enum class TouchKind : std::uint8_t {
  kKick,
  kTackle,  ///< that hit the ball
  kCatch,
  kPunch,  ///< a catch that failed by chance and deflected the ball
};

/// The ball was touched between frame - 1 and frame, by one or more players.
struct Touch {
  std::uint32_t frame = 0;
  /// The toucher: of several players of one team the nearest; kNoPlayer if both teams touched the
  /// ball.
  std::int8_t slot = kNoPlayer;
  TouchKind kind = TouchKind::kKick;
  std::uint32_t touchers = 0;  ///< one bit per slot
  /// Nearest toucher of each team, for contested touches.
  std::array<std::int8_t, 2> nearest = {kNoPlayer, kNoPlayer};
  soccer::Vec2 contact;  ///< position of the ball
  soccer::Vec2 launch;   ///< displacement of the ball in the step: its new velocity
  /// Live phase that the touch starts, belongs to or ends; -1: none.
  std::int32_t live_phase = -1;

  bool contested() const { return slot == kNoPlayer; }
};

/// Derived from a record, which must outlive the flow.
struct Flow {
  const gamelog::MatchRecord* record = nullptr;

  // One entry per frame.
  std::vector<Phase> phase;
  /// Live phase of each frame, from 0; -1 if not live. A drop ball starts a new live phase.
  std::vector<std::int32_t> live_phase;
  std::vector<std::int8_t> owner;  ///< last toucher within the live phase

  std::vector<Touch> touches;         ///< in all phases, by frame
  std::vector<std::uint32_t> placed;  ///< live frames in which the ball was dropped or moved

  bool is_live(std::size_t frame) const { return phase[frame] == Phase::kLive; }

  /// The first frame after a touch that is outside the touch's live phase, or the number of frames.
  /// The touch must have a live phase.
  std::size_t end_of_play(const Touch& touch) const;
};

Flow build_flow(const gamelog::MatchRecord& record);

inline std::size_t entry_of(std::size_t frame, std::size_t slot) {
  return frame * gamelog::kSlots + slot;
}

/// One value per team: left, right.
template <typename T>
using PerTeam = std::array<T, 2>;
template <typename T>
using PerPlayer = std::array<T, gamelog::kSlots>;

constexpr std::size_t kTeamSize = gamelog::kSlots / 2;

/// The slots of each team's players.
constexpr PerTeam<std::array<std::size_t, kTeamSize>> kTeamSlots = {
    {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21}}};

/// A slot other than kNoPlayer as an index.
constexpr std::size_t slot_index(std::int8_t slot) { return base::index(slot); }

// Of a slot other than kNoPlayer.
constexpr soccer::Side side_of(std::integral auto slot) {
  return soccer::side_of_slot(static_cast<int>(slot));
}
constexpr int unum_of(std::integral auto slot) {
  return soccer::unum_of_slot(static_cast<int>(slot));
}
constexpr std::size_t team_of(std::integral auto slot) {
  return base::index(slot) < kTeamSize ? 0 : 1;
}
constexpr std::size_t team_of(soccer::Side side) { return soccer::side_index(side); }
constexpr bool same_team(std::integral auto a, std::integral auto b) {
  return team_of(a) == team_of(b);
}

/// +1 for left, -1 for right: multiplied by it, a position is seen by a team that attacks +x.
constexpr double attack_sign(std::integral auto slot) { return team_of(slot) == 0 ? 1.0 : -1.0; }

/// Bits of a player's state that it did not have a frame before.
inline std::uint32_t newly_set(const gamelog::MatchRecord& record, std::size_t entry) {
  return record.players.state[entry] & ~record.players.state[entry - gamelog::kSlots];
}

/// True for the state of a goalie that caught the ball.
constexpr bool has_caught(std::uint32_t state) {
  return (state & (gamelog::kStateCatch | gamelog::kStateCatchFailed)) == gamelog::kStateCatch;
}

/// True if a player's counter of a command grew between two of its entries, or in the last frame.
inline bool has_executed(const gamelog::MatchRecord& record, gamelog::Counter command,
                         std::size_t before, std::size_t entry) {
  const auto& counters = record.players.counters;
  return counters[entry][base::index(command)] > counters[before][base::index(command)];
}
inline bool has_executed(const gamelog::MatchRecord& record, gamelog::Counter command,
                         std::size_t entry) {
  return has_executed(record, command, entry - gamelog::kSlots, entry);
}

/// Player type of an entry; the default type if the log has none.
const soccer::PlayerType& type_of(const gamelog::MatchRecord& record, std::size_t entry);

/// Maximum distance between the centers of player and ball for a kick.
double kickable_radius(const gamelog::MatchRecord& record, std::size_t entry);

inline bool is_goalie(const gamelog::MatchRecord& record, std::size_t entry) {
  return (record.players.state[entry] & gamelog::kStateGoalie) != 0;
}

/// True if the player was the goalie in any frame: it need not be connected in the first and the
/// last one.
bool was_goalie(const gamelog::MatchRecord& record, std::size_t slot);

}  // namespace cls::analysis
