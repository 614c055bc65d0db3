// Writes a match as chunks, whole or while it grows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "gamelog/record/match_record.h"
#include "viewer/stream/chunk.h"
#include "viewer/stream/stream_state.h"

namespace cls::viewer {

/// Each function appends chunks to `out`. The record may grow between the calls; frames and notes
/// that were written must not change. All chunks of a match written by one writer form a stream.
class ChunkWriter {
 public:
  explicit ChunkWriter(StreamForm form) : form_(form) {}

  /// Called first, and again when parameters or player types have changed.
  void append_header(const gamelog::MatchRecord& record, std::string& out);

  /// Frames from the last written one to `end` (exclusive), and the notes before each of them.
  void append_frames(const gamelog::MatchRecord& record, std::size_t end, std::string& out);

  /// `json`: one match of cls.stats/1.
  void append_statistics(std::string_view json, std::string& out);

  /// Called last: the notes after the last frame, and the end.
  void append_end(const gamelog::MatchRecord& record, std::string& out);

  std::size_t frames() const { return frames_; }

 private:
  void append(ChunkKind kind, std::string_view contents, std::string& out);
  void append_notes(const gamelog::MatchRecord& record, std::size_t before, std::string& out);
  void append_column(const gamelog::MatchRecord& record, std::size_t index, std::size_t end,
                     std::string& contents);

  StreamForm form_;
  StreamState state_;
  std::size_t frames_ = 0;
  std::size_t notes_ = 0;
  std::uint32_t checksum_ = 0;
};

/// The stream of a whole match; `statistics` may be empty.
std::string write_stream(const gamelog::MatchRecord& record, StreamForm form,
                         std::string_view statistics);

}  // namespace cls::viewer
