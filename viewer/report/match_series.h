// Quantities over the time of a match, for charts.
#pragma once

#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "gamelog/record/match_record.h"
#include "viewer/charts/charts.h"

namespace cls::viewer {

/// Ticks at round cycles.
TimeAxis time_axis(const gamelog::MatchRecord& record);

/// The left team's share of the frames in which a team owned the ball, in a window of a tenth of
/// the match around each of 121 equally distant frames. NaN: no such frame.
std::vector<double> possession_over_time(const analysis::MatchStatistics& statistics);

/// The left team's share of touches in the final thirds (analysis/measures/territory.h).
std::vector<double> field_tilt_over_time(const analysis::MatchStatistics& statistics);

/// True if the player is the goalie in the first frame in which it is connected.
bool plays_in_goal(const gamelog::MatchRecord& record, std::size_t slot);

}  // namespace cls::viewer
