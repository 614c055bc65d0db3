// A text log (rcl) in memory: who sent what when, and every word of the referee.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gamelog/record/damage.h"

namespace cls::gamelog {

enum class RclSource : std::uint8_t {
  kPlayer,
  kCoach,    ///< online coach
  kTrainer,  ///< offline coach
  kReferee,
  kOther,  ///< measurements of the server, or something unknown
};

/// One record. The clock is that of reception: commands of (time, stopped) are carried out in the
/// step that leads to the next frame.
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
  /// All texts, one behind the other: datagrams as received, referee words without brackets.
  std::string text;
  std::vector<RclLine> lines;
  /// Names in the order in which they first appear: usually left, then right.
  std::vector<std::string> teams;
  DamageList damage;

  std::string_view text_of(const RclLine& line) const {
    return std::string_view(text).substr(line.offset, line.length);
  }
};

}  // namespace cls::gamelog
