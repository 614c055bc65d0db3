// Matches made up frame by frame, for tests of what is reckoned from them.
#pragma once

#include "gamelog/record/match_record.h"
#include "gamelog/record/record_builder.h"

namespace cls::tests {

/// Twenty-two players stand in two lines, left ones at x = -40 and right ones at x = 40 with
/// y = 3 * (number - 6), the goalkeepers (number 1) before their goals; the ball lies in the
/// centre; play_on. Each of the functions that say so appends one frame.
class ScriptedMatch {
 public:
  ScriptedMatch();

  /// What the next frame will show, to be changed at will.
  gamelog::Frame& next() { return next_; }
  gamelog::PlayerFrame& player(int slot) { return next_.players[static_cast<std::size_t>(slot)]; }

  /// Appends a frame: the ball rolls on, time goes on unless the mode stops it.
  void step();
  void steps(int count);

  /// Appends a frame in which the player has kicked the ball off by `launch`.
  void kick(int slot, soccer::Vec2 launch);

  /// Appends a frame in which the player's tackle has hit the ball.
  void tackle(int slot, soccer::Vec2 launch);

  /// The frames from now on are in this mode.
  void mode(soccer::PlayMode mode) { next_.mode = mode; }

  /// Puts the ball there, at rest.
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
