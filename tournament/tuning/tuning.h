// The state of a tuning: a function of its configuration and of the results of its generations.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "league/rating/statistics.h"
#include "tournament/config/config.h"
#include "tournament/tuning/optimizer.h"
#include "tournament/tuning/race.h"
#include "tournament/tuning/tune_config.h"

namespace cls::tournament {

/// A finished generation.
struct Generation {
  std::vector<Values> candidates;
  std::vector<RaceResult> results;
  Values best;        ///< the best guess after it
  Point coordinates;  ///< of the best guess
  Point spread;       ///< of the next candidates, per coordinate
  Estimate score;     ///< mean of all its pairs, from 0 to 1
};

class Tuning {
 public:
  explicit Tuning(TuneConfig config);

  const TuneConfig& config() const { return config_; }
  const std::vector<Generation>& history() const { return history_; }
  bool finished() const { return static_cast<int>(history_.size()) >= config_.generations; }

  /// The candidates of the generation that follows the history.
  const std::vector<Values>& candidates() const { return candidates_; }
  Race race() const;

  /// Appends the results of that generation.
  void record(std::vector<RaceResult> results);

  /// The best guess: the start values before the first generation.
  Values best() const;
  /// Its uncertainty as the optimizer sees it: the spread of the candidates, in values around the
  /// best guess.
  std::vector<Interval> spread() const;

  int pairs_played() const;

 private:
  void ask();

  TuneConfig config_;
  std::unique_ptr<Optimizer> optimizer_;
  std::vector<Generation> history_;
  std::vector<Values> candidates_;
};

/// Goals a match, or the share of points, that a mean value of pairs shows.
double measured(const TuneConfig& config, double value);

/// "generations/0007".
std::filesystem::path generation_folder(const std::filesystem::path& folder, int generation);

/// The tournament of the next generation below `folder`, with the conditions of `base` and the
/// teams of the configuration; writes the files of its candidates. `opponents` are the sides of
/// the configuration with their names.
base::Result<TournamentConfig> generation_config(const Tuning& tuning, const TournamentConfig& base,
                                                 const std::vector<TeamEntry>& opponents,
                                                 const std::filesystem::path& folder);

/// Records the finished generations below `folder`, however many the configuration asks for.
base::Result<void> replay_generations(Tuning& tuning, const std::filesystem::path& folder);

}  // namespace cls::tournament
