// Ages of beliefs and the pair of numbers that names a moment of a match.
#pragma once

namespace cls::proxy {

/// Ages are in cycles: 0 is "in this cycle". They grow by one each cycle up to kNever, which also
/// stands for "has not happened". The clock may stand still; ages grow all the same.
constexpr int kNever = 1000;

constexpr int older(int age) { return age < kNever ? age + 1 : kNever; }

/// A moment: the server's clock, and how many senses came in since it stands still (0 when it
/// runs, so the kick-off's moment is less than the ones it ends).
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

// Beliefs older than these no longer count as valid (proxy behaviour 3.2).
constexpr int kSelfPositionAgeLimit = 20;
constexpr int kSelfVelocityAgeLimit = 10;
constexpr int kSelfFaceAgeLimit = 5;
constexpr int kBallPositionAgeLimit = 10;
constexpr int kBallRelativeAgeLimit = 5;
constexpr int kBallVelocityAgeLimit = 10;
constexpr int kPlayerPositionAgeLimit = 30;
constexpr int kPlayerVelocityAgeLimit = 5;
constexpr int kPlayerFaceAgeLimit = 2;

}  // namespace cls::proxy
