// Reading the `(show ...)` lines of text logs: nearly all bytes of a game log.
#pragma once

#include <string_view>

#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

/// What went wrong in a line, and where in it.
struct LineProblem {
  std::size_t column = 0;  ///< from 0
  std::string_view what;
};

/// Reads a line that starts with "(show " (log-formats 1.7, versions 4 to 6 and the forms of
/// monitors) and appends its frame. Behind the line there must be a line feed and 64 readable
/// bytes (InputBuffer). False on a damaged line; then the record is as before.
bool read_show(std::string_view line, RecordBuilder& builder, LineProblem& problem);

}  // namespace cls::gamelog
