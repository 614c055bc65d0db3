// The little pictures (XPM) of team graphics.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::soccer {

/// Reads quoted lines: the header "W H COLORS CPP", COLORS lines of colours, H lines of W * CPP
/// characters. `out` gets them without quotes, the header normalised to single blanks. False for
/// anything else; pictures beyond 4096 lines are refused.
bool read_xpm(std::string_view text, std::vector<std::string>& out);

}  // namespace cls::soccer
