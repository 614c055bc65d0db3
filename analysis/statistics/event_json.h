// Goals, shots and all events of a match as JSON lists.
#pragma once

#include "analysis/statistics/json_values.h"
#include "analysis/statistics/match_statistics.h"

namespace cls::analysis {

Json goals_json(const MatchStatistics& all);
Json shot_list_json(const MatchStatistics& all);
Json events_json(const MatchStatistics& all);

}  // namespace cls::analysis
