// Reads a game log frame by frame, in memory that does not grow with the log.
#pragma once

#include <cstddef>
#include <memory>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Sees every frame of a log once, in the order of the log.
class FrameListener {
 public:
  virtual ~FrameListener() = default;

  /// `record` holds this frame at `frame`, and the parameters and teams before it. Earlier frames
  /// and notes may be gone.
  virtual void on_frame(const MatchRecord& record, std::size_t frame) = 0;
};

/// A game log of any version, passed on in pieces.
class FrameStream {
 public:
  /// `source` and `listener` must outlive the stream.
  FrameStream(base::ByteSource& source, FrameListener& listener);
  ~FrameStream();
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// The bytes of the source, to look at the first ones before read_all().
  base::InputBuffer& input() { return input_; }

  /// Reads to the end of the log. Errors are those of read_rcg(). The record has parameters, teams
  /// and errors, but no frames.
  const MatchRecord& read_all();

  /// Frames passed on so far.
  std::size_t frames() const;

 private:
  class DrainingSource;

  MatchRecord record_;
  std::unique_ptr<DrainingSource> draining_;
  base::InputBuffer input_;
};

}  // namespace cls::gamelog
