// Damage as the readers of game logs find it and name it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/io/input_buffer.h"
#include "gamelog/record/damage.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

constexpr const char* kCutOff = "the log is cut off here";
constexpr const char* kNoMoreRoom =
    "more frames or messages than any match has: the rest is left out";

/// At what the input returned last, `column` bytes into it.
Damage damage_at(const base::InputBuffer& input, const MatchRecord& record, std::string what,
                 std::size_t column = 0);

/// Gives line after line to `read(line, kind)`, which is kWhole or kUnfinished. Lines that are too
/// long are damage; so is the first one for which the record has no room, and the last to be seen.
template <typename Read>
void read_lines(base::InputBuffer& input, RecordBuilder& builder, Read read) {
  MatchRecord& record = builder.record();
  std::string_view line;
  for (;;) {
    const base::InputBuffer::Line kind = input.next_line(line);
    if (kind == base::InputBuffer::Line::kEnd) return;
    if (kind == base::InputBuffer::Line::kTooLong) {
      record.damage.add(damage_at(input, record, "a line of more than a megabyte"));
      continue;
    }
    if (!builder.has_room()) {
      record.damage.add(damage_at(input, record, kNoMoreRoom));
      return;
    }
    read(line, kind);
  }
}

}  // namespace cls::gamelog
