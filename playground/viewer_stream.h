// The stream of the viewer from a game log that grows in memory.
#pragma once

#include <string>
#include <string_view>

#include "base/io/byte_sink.h"
#include "gamelog/record/match_record.h"
#include "gamelog/record/record_builder.h"
#include "viewer/stream/growing_stream.h"

namespace cls::playground {

/// Takes the bytes of a text log (rcg of versions 4 to 6), and gives them as chunks of
/// docs/formats/view.md.
class ViewerStream : public base::ByteSink {
 public:
  ViewerStream() = default;
  ViewerStream(const ViewerStream&) = delete;
  ViewerStream& operator=(const ViewerStream&) = delete;

  void write(std::string_view bytes) override { unread_ += bytes; }
  base::Result<void> close() override { return {}; }

  /// The chunks of what came since the last call. With `complete`, which may be said once, they end
  /// the stream.
  std::string take(bool complete);

 private:
  void read_lines();

  std::string unread_;
  bool has_header_ = false;
  bool ended_ = false;
  gamelog::MatchRecord record_;
  gamelog::RecordBuilder builder_{record_};
  viewer::GrowingStream stream_{record_};
};

}  // namespace cls::playground
