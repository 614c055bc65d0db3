// Counting games and pairs.
#include "orchestration/tournament/schedule/match_pairs.h"

#include <algorithm>
#include <map>

namespace cls::orchestration::tournament {
namespace {

// Half points of the team that counts as first: 0, 1 or 2.
int half_points(int sign) { return sign + 1; }

struct OpenPair {
  int matches = 0;  // of the pairing, played or not
  int played = 0;
  int half_points = 0;
};

void add_game(Duel& duel, const ScheduledMatch& match) {
  const Outcome& outcome = *match.outcome;
  const bool first_left = match.fixture.left == duel.first;
  const int sign = first_left ? winner_sign(outcome) : -winner_sign(outcome);
  ++(sign > 0 ? duel.games.won : sign == 0 ? duel.games.drawn : duel.games.lost);
  duel.goals_for += first_left ? outcome.left_score : outcome.right_score;
  duel.goals_against += first_left ? outcome.right_score : outcome.left_score;
}

}  // namespace

bool Duel::paired() const { return total(pairs) > 0; }

Estimate Duel::strength() const {
  if (paired()) return estimate(mean(pairs), variance(pairs), static_cast<int>(total(pairs)));
  return estimate(games.score(), games.variance(), games.games());
}

std::vector<Duel> duels(std::span<const ScheduledMatch> matches) {
  std::map<std::pair<int, int>, Duel> all;
  std::map<int, OpenPair> pairings;
  for (const ScheduledMatch& match : matches) {
    const Fixture& fixture = match.fixture;
    const auto teams = std::minmax(fixture.left, fixture.right);
    OpenPair& pairing = pairings[fixture.pairing];
    ++pairing.matches;
    if (!match.outcome || !match.outcome->played()) continue;
    Duel& duel = all[{teams.first, teams.second}];
    duel.first = teams.first;
    duel.second = teams.second;
    add_game(duel, match);
    const int sign = winner_sign(*match.outcome);
    ++pairing.played;
    pairing.half_points += half_points(fixture.left == duel.first ? sign : -sign);
  }
  for (const ScheduledMatch& match : matches) {
    const OpenPair& pairing = pairings[match.fixture.pairing];
    if (!match.outcome || !match.outcome->played()) continue;
    Duel& duel = all[std::minmax(match.fixture.left, match.fixture.right)];
    const bool complete = pairing.matches == 2 && pairing.played == 2;
    if (!complete) {
      ++duel.single_games;
    } else if (match.fixture.left == duel.first) {  // once for the two matches
      duel.pairs[static_cast<std::size_t>(pairing.half_points)] += 1;
    }
  }
  std::vector<Duel> result;
  for (auto& [teams, duel] : all) result.push_back(std::move(duel));
  return result;
}

Duel turned(const Duel& duel) {
  Duel other = duel;
  std::swap(other.first, other.second);
  std::swap(other.games.won, other.games.lost);
  std::swap(other.goals_for, other.goals_against);
  std::reverse(other.pairs.begin(), other.pairs.end());
  return other;
}

WinDrawLoss record_of(int team, std::span<const Duel> duels) {
  WinDrawLoss record;
  for (const Duel& duel : duels) {
    if (duel.first != team && duel.second != team) continue;
    const WinDrawLoss games = duel.first == team ? duel.games : turned(duel).games;
    record.won += games.won;
    record.drawn += games.drawn;
    record.lost += games.lost;
  }
  return record;
}

std::vector<PairResults> results_of(std::span<const Duel> duels) {
  std::vector<PairResults> results;
  for (const Duel& duel : duels) {
    const WinDrawLoss& games = duel.games;
    results.push_back({duel.first, duel.second, games.won + games.drawn / 2.0,
                       static_cast<double>(games.games())});
  }
  return results;
}

}  // namespace cls::orchestration::tournament
