// The recorded decisions of a part of a match.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::viewer {

/// Cycles of the match, both included.
struct CycleRange {
  int first = 0;
  int last = 0;
};

/// The stream with the decisions of some cycles only; without `ranges` as it is. Errors: as
/// read_decisions().
base::Result<std::string> select_cycles(std::string_view stream,
                                        const std::vector<CycleRange>& ranges);

}  // namespace cls::viewer
