// Fills a match record frame by frame; shared by all readers of game logs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/io/input_buffer.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Limits against corrupt and malicious logs (a frame takes 2.6 kB); real logs stay far below.
constexpr std::size_t kMaxFrames = 200'000;
constexpr std::size_t kMaxNoteBytes = std::size_t{256} << 20;

/// Highest player type id; rcssserver uses up to 17.
constexpr int kMaxPlayerType = 255;
/// Maximum length of a team name in bytes; rcssserver allows 15.
constexpr std::size_t kMaxNameLength = 64;

// Errors of several readers.
constexpr const char* kTruncated = "truncated log";
constexpr const char* kTooManyRecords = "too many frames or messages; the rest is ignored";
constexpr const char* kLineTooLong = "line longer than 1 MiB";

/// Appends frames and notes to a record while a log is read or a match is played.
class RecordBuilder {
 public:
  /// `record` must outlive the builder.
  explicit RecordBuilder(MatchRecord& record) : record_(record) {}

  void add_play_mode(int time, soccer::PlayMode mode);
  void add_teams(int time, const TeamFrames& teams);
  /// Renames the teams in every record in which both have the names of `before`.
  void rename_teams(const TeamFrames& before, const TeamFrames& now);
  void add_message(int time, int board, std::string text);
  void add_unknown_line(std::string text);
  void add_parameter_line(std::string text);

  /// Stores a type at its id; false if the id is out of range.
  bool set_player_type(const soccer::PlayerType& type);

  /// Sets the stopped clock of the last note, for logs that record it.
  void set_stopped(int stopped);

  /// Appends a frame with time, mode and teams; the caller fills in ball and players. The clock is
  /// stopped if the previous frame has the same time, or for `stopped` cycles if that is not 0.
  /// Returns the index of the frame.
  std::size_t begin_frame(int time, int stopped = 0);

  /// Removes the frame that begin_frame() appended.
  void drop_frame();

  /// Sets ball and players of a frame.
  void fill_frame(std::size_t index, const Frame& frame);

  /// Appends a whole frame. Changes of mode and teams become notes.
  void append_frame(const Frame& frame);

  /// False once the limits above are reached.
  bool has_room() const;

  /// Adds an error `column` bytes into what `input` returned last.
  void add_error(const base::InputBuffer& input, std::string message, std::size_t column = 0);
  /// Adds the cause of an error at the same place (ParseErrors::add_cause).
  void add_cause(const base::InputBuffer& input, std::string message);

  MatchRecord& record() { return record_; }

 private:
  void add(int time, decltype(Note::content) content);
  ParseError error_at(const base::InputBuffer& input, std::string message,
                      std::size_t column) const;

  MatchRecord& record_;
  soccer::PlayMode mode_ = soccer::PlayMode::kNull;
  std::size_t note_bytes_ = 0;
};

/// Sets a slot to not connected, all values zero.
void clear_player(PlayerColumns& players, std::size_t entry);

/// Calls `parse(line, kind)` for each line; `kind` is kWhole or kUnfinished. Too long lines are
/// errors. Stops with an error at the first line for which the record has no room.
template <typename Parse>
void for_each_line(base::InputBuffer& input, RecordBuilder& builder, Parse parse) {
  std::string_view line;
  for (;;) {
    const base::InputBuffer::Line kind = input.next_line(line);
    if (kind == base::InputBuffer::Line::kEnd) return;

    if (kind == base::InputBuffer::Line::kTooLong) {
      builder.add_error(input, kLineTooLong);
      continue;
    }

    if (!builder.has_room()) {
      builder.add_error(input, kTooManyRecords);
      return;
    }

    parse(line, kind);
  }
}

}  // namespace cls::gamelog
