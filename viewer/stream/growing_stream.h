// The live stream of a match record that grows.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "gamelog/record/match_record.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::viewer {

/// Each function appends chunks to `out`, together one stream.
class GrowingStream {
 public:
  /// `record` must outlive the object.
  explicit GrowingStream(const gamelog::MatchRecord& record) : record_(record) {}

  /// The frames that have come since the last call, after a header if it has changed; false: none.
  bool append_new(std::string& out);

  /// `json`: one match of cls.stats/1, as it is now.
  void append_statistics(std::string_view json, std::string& out);

  /// The rest and the end; `statistics` may be empty. Called last.
  void append_end(std::string_view statistics, std::string& out);

 private:
  void append_header(std::string& out);

  const gamelog::MatchRecord& record_;
  ChunkWriter writer_{StreamForm{.compact = false, .live = true}};
  std::size_t header_parts_ = 0;
};

}  // namespace cls::viewer
