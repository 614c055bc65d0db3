// Reads a stream of chunks into a match.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "gamelog/record/match_record.h"
#include "viewer/stream/chunk.h"
#include "viewer/stream/stream_state.h"

namespace cls::viewer {

/// A match from a stream. A record of a stream that is not compact equals the one that was written.
struct StreamMatch {
  gamelog::MatchRecord record;
  StreamForm form;
  std::string statistics;  ///< one match of cls.stats/1; empty: none
  bool ended = false;
  bool from_page = false;  ///< set by readers of pages
};

/// Reads chunks in any number of pieces. Errors are final.
class ChunkReader {
 public:
  /// Appends bytes of the stream and reads the chunks that are complete.
  base::Result<void> add(std::string_view bytes);

  const StreamMatch& match() const { return match_; }
  StreamMatch take() && { return std::move(match_); }
  /// True if the bytes so far end with a whole chunk.
  bool at_boundary() const { return waiting_.empty(); }

 private:
  bool read_chunk(std::string_view& rest);
  void read(ChunkKind kind, std::string_view contents);
  void read_header(std::string_view contents);
  void read_parameters(std::string_view contents);
  void read_notes(std::string_view contents);
  void read_frames(std::string_view contents);
  void read_column(std::size_t index, std::size_t first, std::size_t frames, ByteReader& in);
  void read_end(std::string_view contents);
  void fail(std::string message);

  StreamMatch match_;
  StreamState state_;
  std::string waiting_;  // the start of a chunk
  std::string error_;
  std::size_t note_bytes_ = 0;
  std::uint32_t checksum_ = 0;
  bool has_header_ = false;
};

/// A whole stream; one without its end is an error.
base::Result<StreamMatch> read_stream(std::string_view bytes);

}  // namespace cls::viewer
