// Parses the `(show ...)` lines of text logs. Hand-written because they are nearly all bytes of a
// game log.
#pragma once

#include <string_view>

#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

/// An error in a line and its position.
struct LineError {
  std::size_t column = 0;  ///< from 0
  std::string_view message;
};

/// Parses a line that starts with "(show " (docs/spec/log-formats.md 1.7, versions 4 to 7 and the
/// forms of monitors) and appends its frame. A line feed and 64 readable bytes must follow the line
/// (InputBuffer). Returns false for a corrupt line; then the record is unchanged. A number that is
/// out of range is limited, and reported in `error`, whose message is otherwise empty on success.
bool read_show(std::string_view line, RecordBuilder& builder, LineError& error);

}  // namespace cls::gamelog
