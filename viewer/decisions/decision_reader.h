// Reads the recorded decisions of a team.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "viewer/decisions/decision_sample.h"

namespace cls::viewer {

struct TeamDecisions {
  soccer::Side side = soccer::Side::kLeft;
  std::string team;
  std::array<std::vector<DecisionSample>, soccer::kPlayersPerTeam> players;  ///< by unum - 1
};

/// A whole stream of DecisionWriter. Errors: another schema, other columns, corrupt, no end.
base::Result<TeamDecisions> read_decisions(std::string_view stream);

/// The stream with the chunks of some players only; empty `unums`: as it is. Errors: another
/// schema, other columns, no end.
base::Result<std::string> select_players(std::string_view stream, const std::vector<int>& unums);

/// Cycles of the match, both included.
struct CycleRange {
  int first = 0;
  int last = 0;
};

/// The stream with the decisions of some cycles only; without `ranges` as it is. Errors: as
/// read_decisions().
base::Result<std::string> select_cycles(std::string_view stream,
                                        const std::vector<CycleRange>& ranges);

/// The stream without its latencies, which are not the same in each run: what remains is, if the
/// match is. Error: no end.
base::Result<std::string> without_latencies(std::string_view stream);

}  // namespace cls::viewer
