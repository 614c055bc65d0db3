// The table of player types that the published data sets have (player_types.csv).
#pragma once

#include <string>

#include "gamelog/record/match_record.h"

namespace cls::analysis {

/// A row for each player type of the log, in its order (docs/data.md): the bytes of rcg2csv. Empty
/// for a log without types (versions 1 and 2).
std::string player_type_table(const gamelog::MatchRecord& record);

}  // namespace cls::analysis
