// Everything that is reckoned from one match.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/measures/movement.h"
#include "analysis/measures/pass_network.h"
#include "analysis/measures/positions.h"
#include "analysis/measures/possession.h"
#include "analysis/measures/pressing.h"
#include "analysis/measures/responsiveness.h"
#include "analysis/measures/stamina.h"
#include "analysis/measures/territory.h"
#include "analysis/measures/threat.h"
#include "analysis/play/carries.h"
#include "analysis/play/chains.h"
#include "analysis/play/flow.h"
#include "analysis/play/goalkeeping.h"
#include "analysis/play/passes.h"
#include "analysis/play/shots.h"
#include "analysis/play/stoppages.h"
#include "analysis/play/tackles.h"
#include "analysis/results/match_summary.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

/// What one player did with the ball: counts that several families add to.
struct BallWork {
  int touches = 0;
  int passes = 0;  ///< attempted
  int completed = 0;
  double pass_length = 0.0;  ///< sum over completed ones, metres
  double pass_gain = 0.0;    ///< sum of forward gains (> 0) over completed ones
  int received = 0;
  int through_passes = 0;
  int crosses = 0;
  int key_passes = 0;  ///< completed, and the receiver's next touches led to a shot
  int assists = 0;
  int second_assists = 0;
  int dribbles = 0;
  int take_ons = 0;  ///< opponents he went past with the ball
  int shots = 0;
  int on_target = 0;
  int goals = 0;
  int own_goals = 0;
  double expected_goals = 0.0;
  double threat = 0.0;
  int losses = 0;  ///< passes that an opponent or nobody's foot ended in play
};

/// A weighted sum of what a player did: goals 10, assists 5, shots on target 1.5, key passes 2,
/// completed passes 0.1 + 0.02 a metre forward, interceptions and effective tackles 1, losses -0.7,
/// fouls -1, yellow -2, red -6, own goals -8, saves 3, goals conceded -1.5 (goalkeeper). Good for
/// an order of players within a match, for nothing else.
struct Rating {
  double attack = 0.0;
  double passing = 0.0;
  double defence = 0.0;
  double discipline = 0.0;

  double total() const { return attack + passing + defence + discipline; }
};

struct MatchStatistics {
  Flow flow;
  Possession possession;
  std::vector<Shot> shots;
  std::vector<double> expected;  ///< probability of a goal, one a shot
  std::vector<Goal> goals;
  std::vector<Assist> assists;  ///< one a goal
  std::vector<Pass> passes;
  std::vector<Carry> carries;
  std::vector<Chain> chains;
  PerTeam<int> one_twos = {};
  PerPlayer<Tackles> tackles = {};
  Territory territory;
  Stoppages stoppages;
  PerTeam<Goalkeeping> goalkeeping = {};
  PressingStats pressing;
  PerPlayer<Movement> movement = {};
  PerPlayer<Stamina> stamina = {};
  PositionStats positions;
  PerTeam<PassNetwork> networks = {};
  ThreatGrid threat = {};
  PerPlayer<Attention> attention = {};
  std::optional<PerPlayer<Responsiveness>> responsiveness;  ///< with a text log only
  PerPlayer<BallWork> ball_work = {};
  PerPlayer<Rating> ratings = {};
};

/// `record` must outlive the result; `text` is the text log of the same match, or null.
MatchStatistics statistics_of(const gamelog::MatchRecord& record, const gamelog::RclRecord* text);

/// Why the match should not count in a comparison of teams (match-statistics 5): players lost or
/// missing, too many silent cycles, no end. Empty: nothing speaks against it. `summary` is of the
/// same match.
std::vector<std::string> doubts_about(const MatchSummary& summary,
                                      const MatchStatistics& statistics);

}  // namespace cls::analysis
