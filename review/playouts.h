// A recorded moment, played on many times after each of several decisions.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "analysis/play/flow.h"
#include "base/result.h"
#include "review/alternatives.h"
#include "review/decisions.h"
#include "simulator/replay/logged_match.h"
#include "soccer/commands/player_command.h"
#include "training/episode/episode.h"

namespace cls::review {

/// Commands of the player in `slot` that the server executed in the step after the frame of this
/// cycle of running play.
std::vector<soccer::PlayerCommand> commands_sent(const simulator::TextLogIndex& sent, int slot,
                                                 int cycle);

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
                                        const analysis::Flow& flow,
                                        const simulator::TextLogIndex& sent,
                                        const Decision& decision, const PlayoutTerms& terms);

}  // namespace cls::review
