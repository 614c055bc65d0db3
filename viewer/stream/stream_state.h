// The memory of writers and readers of a stream from one chunk of frames to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "viewer/stream/column_codec.h"
#include "viewer/stream/stream_header.h"

namespace cls::viewer {

/// The columns of a stream and where they stand. Columns are coded in order, between begin_frames()
/// calls.
class StreamState {
 public:
  /// Another header of the same stream continues the states of its columns, if they are the same.
  void set_header(StreamHeader header);
  const StreamHeader& header() const { return header_; }

  /// Called before the columns of a chunk.
  void begin_frames();

  /// The input for column `index` in a chunk of `frames` frames. Refers to this object; valid until
  /// the next call.
  CodingInput input(std::size_t index, std::size_t frames);
  ColumnState& state(std::size_t index) { return states_[index]; }

  /// Called after a column was coded, with its integers.
  void keep(std::size_t index, Integers integers);

 private:
  StreamHeader header_;
  std::vector<ColumnState> states_;
  std::vector<Integers> integers_;                 ///< of this chunk, of columns that others need
  std::vector<std::vector<std::int64_t>> before_;  ///< states of these columns before this chunk
  Integers predictions_;
};

}  // namespace cls::viewer
