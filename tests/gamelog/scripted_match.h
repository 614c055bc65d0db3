// Builds matches frame by frame, for tests of statistics.
#pragma once

#include "gamelog/record/match_record.h"
#include "gamelog/record/record_builder.h"

namespace cls::tests {

/// Twenty-two players stand in two lines, the left team at x = -40 and the right team at x = 40
/// with y = 3 * (unum - 6), the goalies (unum 1) in front of their goals. The ball lies in the
/// center; the mode is play_on. Functions that append a frame say so.
class ScriptedMatch {
 public:
  ScriptedMatch();

  /// The player in the next frame, for changes.
  gamelog::Frame& next() { return next_; }
  gamelog::PlayerFrame& player(int slot) { return next_.players[static_cast<std::size_t>(slot)]; }

  /// Appends a frame: the ball moves, time advances unless the mode stops the clock.
  void step();
  void steps(int count);

  /// Appends a frame in which the player has kicked the ball with velocity `launch`.
  void kick(int slot, soccer::Vec2 launch);

  /// Appends a frame in which the player's tackle has hit the ball.
  void tackle(int slot, soccer::Vec2 launch);

  /// Sets the play mode of the following frames.
  void mode(soccer::PlayMode mode) { next_.mode = mode; }

  /// Places the ball, at rest.
  void place_ball(soccer::Vec2 position);

  void score(int left, int right);

  const gamelog::MatchRecord& record() const { return record_; }
  gamelog::MatchRecord& record() { return record_; }

 private:
  void append();

  gamelog::MatchRecord record_;
  gamelog::RecordBuilder builder_{record_};
  gamelog::Frame next_;
};

constexpr int left(int unum) { return unum - 1; }
constexpr int right(int unum) { return unum + 10; }

}  // namespace cls::tests
