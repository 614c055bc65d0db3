// The table of events that the published data sets have (event.csv): what the ball did between two
// touches.
#pragma once

#include <string>

#include "analysis/play/flow.h"

namespace cls::analysis {

/// A row for each event (docs/data.md), sorted by the time of its first touch.
std::string event_table(const Flow& flow);

}  // namespace cls::analysis
