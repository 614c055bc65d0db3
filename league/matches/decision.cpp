// Applies decisions in the order in which they were made.
#include "league/matches/decision.h"

#include <algorithm>

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

std::vector<MatchDecision> decisions_of(std::span<const ScheduledMatch> matches,
                                        DecisionKind kind) {
  std::vector<MatchDecision> found;
  for (const ScheduledMatch& match : matches) {
    for (const MatchDecision& one : match.history) {
      if (one.kind == kind) found.push_back(one);
    }
  }
  return found;
}

// The decision on a match of teams of which at least one has left.
MatchDecision forfeit_of(const Fixture& fixture, const MatchDecision& withdrawal, bool both) {
  MatchDecision decision = withdrawal;
  decision.match = fixture.index;
  decision.kind = both ? DecisionKind::kAnnul : DecisionKind::kAward;
  const bool left = withdrawal.teams.front() == fixture.left;
  decision.left_score = both || left ? 0 : kForfeitGoals;
  decision.right_score = both || !left ? 0 : kForfeitGoals;
  return decision;
}

void plan_replay(ScheduledMatch& match, std::uint64_t seed) {
  match.replay_seed = seed;
  if (match.fixture.seed == seed) return;
  match.fixture.seed = seed;
  match.outcome.reset();
}

void follow_decision(ScheduledMatch& match) {
  if (!match.decision) return;
  if (match.decision->kind == DecisionKind::kAward) {
    match.outcome = awarded(match.outcome.value_or(Outcome()), *match.decision);
  } else if (match.decision->kind == DecisionKind::kAnnul) {
    if (!match.outcome) match.outcome = Outcome();
    match.outcome->annulled = true;
  }
}

}  // namespace

std::uint64_t seed_of_replay(std::uint64_t seed) { return pairing_seed(seed, 1); }

void apply_decisions(std::span<ScheduledMatch> matches, std::span<const MatchDecision> decisions) {
  for (const MatchDecision& decision : decisions) {
    const auto at = static_cast<std::size_t>(decision.match) - 1;
    if (at >= matches.size()) continue;  // its round is drawn again
    ScheduledMatch& match = matches[at];

    match.history.push_back(decision);
    if (is_about_teams(decision.kind)) continue;
    match.decision.reset();
    if (decision.kind != DecisionKind::kAsPlayed) match.decision = decision;
    // Of a match that is replayed twice only the last seed matters, which is also its stored one.
    if (decision.kind == DecisionKind::kReplay) match.replay_seed = decision.seed;
  }

  for (ScheduledMatch& match : matches) {
    if (match.replay_seed) plan_replay(match, *match.replay_seed);
    follow_decision(match);
  }
  award_withdrawn(matches);
}

std::vector<int> withdrawn_teams(std::span<const ScheduledMatch> matches) {
  std::vector<int> teams;
  for (const MatchDecision& one : decisions_of(matches, DecisionKind::kWithdraw)) {
    teams.push_back(one.teams.front());
  }
  return teams;
}

std::vector<int> award_withdrawn(std::span<ScheduledMatch> matches) {
  std::vector<int> numbers;
  const std::vector<MatchDecision> withdrawals = decisions_of(matches, DecisionKind::kWithdraw);
  if (withdrawals.empty()) return numbers;

  for (ScheduledMatch& match : matches) {
    if (match.outcome) continue;
    const auto concerns = [&match](const MatchDecision& one) {
      return one.teams.front() == match.fixture.left || one.teams.front() == match.fixture.right;
    };
    const auto first = std::ranges::find_if(withdrawals, concerns);
    if (first == withdrawals.end()) continue;
    const bool both = std::ranges::count_if(withdrawals, concerns) > 1;
    match.decision = forfeit_of(match.fixture, *first, both);
    follow_decision(match);
    numbers.push_back(match.fixture.index);
  }
  return numbers;
}

bool is_by_withdrawal(const ScheduledMatch& match) {
  return match.decision && !match.decision->teams.empty();
}

std::vector<MatchDecision> decided_orders(std::span<const ScheduledMatch> matches) {
  return decisions_of(matches, DecisionKind::kOrder);
}

}  // namespace cls::league
