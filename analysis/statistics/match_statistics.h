// All statistics of a match.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/measures/pass_network.h"
#include "analysis/measures/physical.h"
#include "analysis/measures/position_stats.h"
#include "analysis/measures/possession.h"
#include "analysis/measures/pressing.h"
#include "analysis/measures/responsiveness.h"
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

/// Actions of one player with the ball.
struct BallActions {
  int touches = 0;
  int passes = 0;  ///< attempted
  int completed = 0;
  double pass_length = 0.0;  ///< sum over completed passes, meters
  double pass_gain = 0.0;    ///< sum of forward gains (> 0) over completed passes
  int received = 0;
  int through_passes = 0;
  int crosses = 0;
  int key_passes = 0;  ///< completed, and the receiver's next touches led to a shot
  int assists = 0;
  int second_assists = 0;
  int dribbles = 0;
  int take_ons = 0;  ///< opponents passed with the ball
  int shots = 0;
  int on_target = 0;
  int goals = 0;
  int own_goals = 0;
  double expected_goals = 0.0;
  double threat = 0.0;
  int losses = 0;  ///< passes intercepted by an opponent or touched next by both teams

  double mean_pass_length() const { return completed == 0 ? 0.0 : pass_length / completed; }
};

/// Rating: a weighted sum of actions. Goals 10, assists 5, shots on target 1.5, key passes 2,
/// completed passes 0.1 + 0.02 per meter forward, interceptions and effective tackles 1, losses
/// -0.7, fouls -1, yellow cards -2, red cards -6, own goals -8, saves 3, goals conceded -1.5
/// (goalie). Only meaningful for ranking players within a match.
struct Rating {
  double attack = 0.0;
  double passing = 0.0;
  double defense = 0.0;
  double discipline = 0.0;

  double total() const { return attack + passing + defense + discipline; }
};

struct MatchStatistics {
  Flow flow;
  Possession possession;
  std::vector<Shot> shots;
  std::vector<double> expected;  ///< goal probability, one per shot
  std::vector<Goal> goals;
  std::vector<Assist> assists;  ///< one per goal
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
  PerPlayer<BallActions> ball_actions = {};
  PerPlayer<Rating> ratings = {};
};

/// `record` must outlive the result; `text` is the text log of the same match, or null.
MatchStatistics compute_statistics(const gamelog::MatchRecord& record,
                                   const gamelog::RclRecord* text);

/// Reasons to exclude the match from a comparison of teams (docs/spec/match-statistics.md 5):
/// disconnected or missing players, too many silent steps, no end. `summary` is of the same match.
std::vector<std::string> exclusion_reasons(const MatchSummary& summary,
                                           const MatchStatistics& statistics);

}  // namespace cls::analysis
