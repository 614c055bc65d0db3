// Ages of estimates, and the game time of an agent: cycle and stopped-clock counter.
#pragma once

namespace cls::player {

/// Ages are in cycles: 0 means this cycle. They grow by one per cycle, also while the clock is
/// stopped, up to kNever, which also means "has not happened".
constexpr int kNever = 1000;

constexpr int older(int age) { return age < kNever ? age + 1 : kNever; }

/// Server cycle, and the number of sense_body messages since the clock stopped (0 while it runs, so
/// the step of the kick-off is less than the stopped steps before it).
struct GameTime {
  int cycle = -1;
  int stopped = 0;

  friend constexpr bool operator==(GameTime a, GameTime b) {
    return a.cycle == b.cycle && a.stopped == b.stopped;
  }
  friend constexpr bool operator<(GameTime a, GameTime b) {
    return a.cycle != b.cycle ? a.cycle < b.cycle : a.stopped < b.stopped;
  }
};

// Estimates at least this old are no longer valid (docs/spec/proxy-behavior.md 3.2).
constexpr int kSelfPositionAgeLimit = 20;
constexpr int kSelfVelocityAgeLimit = 10;
constexpr int kSelfFaceAgeLimit = 5;
constexpr int kBallPositionAgeLimit = 10;
constexpr int kBallRelativeAgeLimit = 5;
constexpr int kBallVelocityAgeLimit = 10;
constexpr int kPlayerPositionAgeLimit = 30;
constexpr int kPlayerVelocityAgeLimit = 5;
constexpr int kPlayerFaceAgeLimit = 2;

}  // namespace cls::player
