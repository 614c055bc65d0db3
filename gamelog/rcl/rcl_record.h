// A text log (rcl) in memory: received commands and referee messages with their clock.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/parse_errors.h"

namespace cls::gamelog {

enum class RclSource : std::uint8_t {
  kPlayer,
  kCoach,    ///< online coach
  kTrainer,  ///< offline coach
  kReferee,
  kOther,  ///< measurements of the server, or unknown
};

/// One record with the clock of its reception. The server executes commands of (time, stopped) in
/// the step that leads to the next frame.
struct RclLine {
  std::int32_t time = 0;
  std::int32_t stopped = 0;
  std::uint32_t offset = 0;  ///< of the text in RclRecord::text
  std::uint32_t length = 0;
  RclSource source = RclSource::kOther;
  std::uint8_t team = 0;  ///< index into RclRecord::teams; players and coaches only
  std::uint8_t unum = 0;  ///< players only
};

struct RclRecord {
  /// All texts, concatenated: datagrams as received, referee messages without brackets.
  std::string text;
  std::vector<RclLine> lines;
  /// Names in order of first appearance: usually left, then right.
  std::vector<std::string> teams;
  ParseErrors errors;

  std::string_view text_of(const RclLine& line) const {
    return std::string_view(text).substr(line.offset, line.length);
  }
};

}  // namespace cls::gamelog
