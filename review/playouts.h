// A recorded moment, played on many times after each of several decisions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/play/flow.h"
#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"
#include "review/alternatives.h"
#include "review/decisions.h"
#include "training/episode/episode.h"

namespace cls::review {

/// Commands that a player sent, by cycle, from the text log of a match.
class SentCommands {
 public:
  SentCommands(const gamelog::MatchRecord& record, const gamelog::RclRecord& log);

  /// Those that the server executed in the step after a frame of this cycle.
  std::vector<soccer::PlayerCommand> of(int slot, int cycle) const;

 private:
  struct Line {
    int cycle;
    int slot;
    std::string_view text;
  };
  std::vector<Line> lines_;  ///< sorted by cycle and slot, of each in the order of the log
};

struct PlayoutTerms {
  int seeds = 40;  ///< playouts of each decision
  int cycles = kDecisionHorizon;
  std::size_t most_alternatives = 8;
  std::uint64_t seed = 1;
};

/// The goals that a decision was worth in each playout: 1 or -1 after a goal, else the value of
/// the last state.
using Worths = std::vector<double>;

struct PlayedDecision {
  Decision decision;
  std::vector<Alternative> alternatives;
  Worths recorded;             ///< with the commands of the match
  std::vector<Worths> worths;  ///< of the alternatives
};

/// Plays the moment of a decision again. A pure function. The error says why it cannot.
base::Result<PlayedDecision> play_again(std::shared_ptr<const training::Setup> setup,
                                        const analysis::Flow& flow, const SentCommands& sent,
                                        const Decision& decision, const PlayoutTerms& terms);

}  // namespace cls::review
