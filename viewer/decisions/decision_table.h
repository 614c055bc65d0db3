// Recorded world models as a table.
#pragma once

#include <vector>

#include "base/io/byte_sink.h"
#include "viewer/decisions/decision_reader.h"

namespace cls::viewer {

/// Writes an Arrow file with a row for each decision, team by team and player by player: who, the
/// columns of docs/formats/decisions.md (22 series as a list), the texts and the latency.
void write_decisions_arrow(const std::vector<TeamDecisions>& teams, base::ByteSink& sink);

}  // namespace cls::viewer
