// Team names with blanks in text logs: the server allows none, other writers may.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/record/frame.h"

namespace cls::gamelog {

/// A `(team ...)` record whose names hold blanks, read from its right end; split_names() names the
/// teams.
struct BlankNames {
  int time = 0;
  TeamFrames teams;
  std::string names;  ///< both, as they stand in the record
};

/// False if the line is no such record either.
bool read_blank_names(std::string_view line, BlankNames& record);

/// Where one name ends and the other begins: as the text of the result message tells
/// (`(result DATE LEFT_1-vs-RIGHT_2)`), else, or if it does not fit, at the blank in the middle.
void split_names(std::string_view names, std::string_view result, TeamFrames& teams);

}  // namespace cls::gamelog
