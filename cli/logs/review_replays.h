// The costliest decisions of the matches of a review, played again.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/match_statistics.h"
#include "base/system/parallel.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcl/rcl_reader.h"
#include "gamelog/record/match_record.h"
#include "review/review.h"
#include "review/saved_decisions.h"
#include "simulator/replay/logged_match.h"

namespace cls::cli {

/// A match whose game log was read.
struct LoadedMatch {
  gamelog::MatchLogs logs;
  gamelog::MatchRecord record;
};

struct ReplayOptions {
  std::size_t decisions = 0;  ///< to be played again
  std::string continued_by = "planner";
  std::string save;  ///< file of the review, which a later run continues; empty: none
  std::size_t jobs = base::default_jobs();
};

class Replays {
 public:
  Replays(const ReplayOptions& options, review::Review& review)
      : options_(options), review_(review) {}

  /// Takes what an earlier run has saved, if there is such a file: an exit code, after an error
  /// line where the file is something else.
  int continue_saved();

  /// Adds the last match of the review, with its decisions. `loaded` must outlive the calls.
  void add(const LoadedMatch& loaded, analysis::MatchStatistics statistics, soccer::Side side);

  /// Chooses the decisions, plays those that were not saved, and adds all to the review: an exit
  /// code, after an error line where they cannot be saved.
  int play();

  /// Writes a scenario of each decision that has a better alternative,
  /// MATCH-CYCLE-player-UNUM.json: an exit code, after an error line where one cannot be written.
  int write_scenarios(const std::string& folder) const;

 private:
  /// A match of the team, and what playing its decisions again needs.
  struct PlayedMatch {
    const LoadedMatch* loaded = nullptr;
    analysis::Flow flow;
    gamelog::RclRecord text;
    std::optional<simulator::TextLogIndex> sent;  ///< of `text`
    std::shared_ptr<const training::Setup> setup;
    std::string problem;  ///< why its decisions cannot be played
  };

  struct Candidate {
    std::size_t match = 0;
    review::Decision decision;
    std::optional<review::Verdict> verdict;
    std::string problem;  ///< why it cannot be played
  };

  void choose();
  void prepare_matches();
  void prepare(PlayedMatch& match) const;
  void play(Candidate& candidate);
  void assemble();
  void save();

  const ReplayOptions& options_;
  review::Review& review_;
  review::SavedDecisions saved_;
  std::vector<PlayedMatch> matches_;  ///< as in the review
  std::vector<Candidate> candidates_;
  std::mutex mutex_;  ///< of verdicts, problems, the review and its file
  std::string save_error_;
};

}  // namespace cls::cli
