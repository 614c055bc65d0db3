// A match in a terminal: what is shown, and what keys do.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gamelog/record/match_record.h"
#include "viewer/terminal/screen.h"

namespace cls::viewer {

enum class Key {
  kPlay,
  kBack,
  kForward,
  kBackTen,
  kForwardTen,
  kStart,
  kEnd,
  kSlower,
  kFaster,
  kNextGoal,
  kPreviousGoal,
  kLive,
  kQuit,
};

/// Removes whole keys from the start of `bytes`, as terminals send them; unknown ones are skipped.
std::vector<Key> take_keys(std::string& bytes);

/// Shows a record, which may grow. The moment is a frame and a fraction of the next one.
class MatchScreen {
 public:
  /// `record` must outlive the screen.
  explicit MatchScreen(const gamelog::MatchRecord& record) : record_(record) {}

  /// Whether more frames follow; then the screen shows the newest one until a key goes back.
  void set_live(bool live);
  void seek(std::size_t frame);
  void press(Key key);
  /// Plays on for these seconds of real time.
  void advance(double seconds);

  bool has_quit() const { return quit_; }
  bool playing() const { return playing_; }
  std::size_t frame() const;
  /// True if it plays and has reached the last frame of a match without more.
  bool at_end() const;

  Screen draw(int columns, int rows, bool color) const;
  /// One line: "cycle 1234, play_on, A 1 : 0 B".
  std::string line() const;

 private:
  std::size_t last() const;
  void step(double frames);
  void find_goal(int direction);
  void draw_head(Screen& screen) const;
  void draw_foot(Screen& screen) const;

  const gamelog::MatchRecord& record_;
  double at_ = 0.0;
  std::size_t speed_ = 3;
  bool playing_ = true;
  bool live_ = false;
  bool following_ = false;
  bool quit_ = false;
};

}  // namespace cls::viewer
