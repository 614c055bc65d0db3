// Applies decisions in the order in which they were made.
#include "league/matches/decision.h"

#include "league/matches/fixture.h"

namespace cls::league {

Outcome awarded(Outcome outcome, const MatchDecision& decision) {
  outcome.forfeit = true;
  outcome.left_score = decision.left_score;
  outcome.right_score = decision.right_score;
  outcome.left_penalties = decision.left_penalties;
  outcome.right_penalties = decision.right_penalties;
  return outcome;
}

namespace {

void plan_replay(ScheduledMatch& match, std::uint64_t seed) {
  match.replay_seed = seed;
  if (match.fixture.seed == seed) return;
  match.fixture.seed = seed;
  match.outcome.reset();
}

}  // namespace

std::uint64_t seed_of_replay(std::uint64_t seed) { return pairing_seed(seed, 1); }

void apply_decisions(std::span<ScheduledMatch> matches, std::span<const MatchDecision> decisions) {
  for (const MatchDecision& decision : decisions) {
    const auto at = static_cast<std::size_t>(decision.match) - 1;
    if (at >= matches.size()) continue;  // its round is drawn again
    ScheduledMatch& match = matches[at];

    match.history.push_back(decision);
    match.decision.reset();
    if (decision.kind != DecisionKind::kAsPlayed) match.decision = decision;
    // Of a match that is replayed twice only the last seed matters, which is also its stored one.
    if (decision.kind == DecisionKind::kReplay) match.replay_seed = decision.seed;
  }

  for (ScheduledMatch& match : matches) {
    if (match.replay_seed) plan_replay(match, *match.replay_seed);
    if (!match.decision) continue;
    if (match.decision->kind == DecisionKind::kAward) {
      match.outcome = awarded(match.outcome.value_or(Outcome()), *match.decision);
    } else if (match.decision->kind == DecisionKind::kAnnul) {
      if (!match.outcome) match.outcome = Outcome();
      match.outcome->annulled = true;
    }
  }
}

}  // namespace cls::league
