// Recorded outcomes that replace random draws during log replay.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "simulator/world/player.h"

namespace cls::simulator {

enum class FoulCall : std::uint8_t { kNone, kCharge, kYellow, kRed };

/// A random outcome per player. The simulation draws as usual, so that random streams stay in step,
/// and then passes the drawn value through replace().
template <typename T>
struct OutcomeOverride {
  std::array<std::optional<T>, soccer::kPlayersOnPitch> recorded;
  std::bitset<soccer::kPlayersOnPitch> drawn;  ///< players for whom the step drew an outcome

  /// Returns the recorded value, or `value` if none is recorded. `random` is false for a certain
  /// outcome.
  T replace(Slot slot, T value, bool random = true) {
    const auto i = static_cast<std::size_t>(slot);
    if (random) drawn.set(i);
    return recorded[i].value_or(value);
  }
};

/// Recorded motion of an object in one step, and the noise that explains it.
struct RecordedMotion {
  std::optional<Vec2> arrival;  ///< the noise is chosen to end here if it can

  // Written by the step:
  Vec2 noise;              ///< chosen noise; zero if noise cannot explain the arrival
  double noise_max = 0.0;  ///< radius of the disc from which motion noise is drawn
  Vec2 expected;           ///< arrival without noise
  double reach = 0.0;      ///< maximum distance from `expected`, with noise of motion and of kicks
  bool explained = false;
};

/// World::overrides of a log replay (replay/log_replay.h): the recorded match decides what the live
/// simulation draws. The step writes which draws it needed.
struct ReplayOverrides {
  OutcomeOverride<bool> tackle;      ///< success
  OutcomeOverride<bool> catch_ball;  ///< success
  OutcomeOverride<FoulCall> foul;    ///< by tackler
  OutcomeOverride<Vec2> placement;   ///< random position chosen by the referee
  std::array<std::optional<double>, soccer::kPlayersOnPitch> body;  ///< radians, after a turn
  std::array<RecordedMotion, soccer::kPlayersOnPitch> players;
  RecordedMotion ball;
  std::optional<Side> shoot_out_goal;
  std::optional<Side> first_penalty_taker;

  // Written by the step; kicks and tackles have no noise during replay.
  double push_noise_max = 0.0;    ///< sum over kicks and tackles of the maximum noise
  double push_noise_mean2 = 0.0;  ///< sum of the mean squares of that noise
};

}  // namespace cls::simulator
