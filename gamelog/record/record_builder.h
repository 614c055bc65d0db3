// Filling a match record frame by frame: what all readers of game logs have in common.
#pragma once

#include <cstddef>
#include <string>

#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// No real log comes near; hostile ones must not eat the memory (2.6 kB a frame).
constexpr std::size_t kMaxFrames = 200'000;
constexpr std::size_t kMaxNoteBytes = std::size_t{256} << 20;

/// Numbers of player types end here; real ones at 17.
constexpr int kHighestType = 255;
/// Longer names of teams are no names; the server allows 15 characters.
constexpr std::size_t kLongestName = 64;

/// Keeps what holds for the next frame while a log is read, or a match is played.
class RecordBuilder {
 public:
  /// `record` must outlive the builder.
  explicit RecordBuilder(MatchRecord& record) : record_(record) {}

  void play_mode(int time, soccer::PlayMode mode);
  void teams(int time, const TeamFrames& teams);
  /// Gives teams other names, wherever both have had the names of `before`.
  void rename(const TeamFrames& before, const TeamFrames& now);
  void message(int time, int board, std::string text);
  void unknown_line(std::string text);
  void parameter_line(std::string text);

  /// Puts a type in the place of its number; false if that is none.
  bool player_type(const soccer::PlayerType& type);

  /// The stopped clock of the note before, where a log names it.
  void note_stopped(int stopped);

  /// Appends a frame with time, mode and teams; ball and players are the caller's to fill in. The
  /// clock stands if the frame before has the same time, or for `stopped` cycles if the log says so
  /// (0: it does not). Returns the index of the frame.
  std::size_t begin_frame(int time, int stopped = 0);

  /// Takes the frame that begin_frame() gave away again.
  void drop_frame();

  /// Ball and players of the frame that begin_frame() gave.
  void fill(std::size_t index, const Frame& frame);

  /// A whole frame. Mode and teams become notes where they differ from what held before.
  void append(const Frame& frame);

  /// False once the limits above are reached.
  bool has_room() const;

  MatchRecord& record() { return record_; }

 private:
  void add(int time, decltype(Note::content) content);

  MatchRecord& record_;
  soccer::PlayMode mode_ = soccer::PlayMode::kNull;
  std::size_t note_bytes_ = 0;
};

/// An empty slot: not connected, everything zero.
void clear_player(PlayerColumns& players, std::size_t entry);

}  // namespace cls::gamelog
