// The files of the Common Data Format with a line for each event and for each frame.
#pragma once

#include <string>

#include "analysis/tables/cdf_match.h"
#include "base/io/byte_sink.h"

namespace cls::analysis {

/// A line for each event of a known player (docs/data.md).
std::string cdf_events(const CdfMatch& match);

/// A line for each frame with ball and connected players.
void write_cdf_tracking(const CdfMatch& match, base::ByteSink& sink);

}  // namespace cls::analysis
