// Counts games and pairs.
#include "league/matches/head_to_head.h"

#include <algorithm>
#include <map>

namespace cls::league {
namespace {

// Half points of the first team: 0, 1 or 2.
int half_points(int sign) { return sign + 1; }

struct OpenPair {
  int matches = 0;  // of the pairing, played or not
  int played = 0;
  int half_points = 0;
};

void add_game(HeadToHead& head_to_head, const ScheduledMatch& match) {
  const Outcome& outcome = *match.outcome;
  const bool first_left = match.fixture.left == head_to_head.first;
  const int sign = first_left ? winner_sign(outcome) : -winner_sign(outcome);
  ++(sign > 0    ? head_to_head.games.won
     : sign == 0 ? head_to_head.games.drawn
                 : head_to_head.games.lost);
  if (had_shoot_out(outcome) && sign != 0) {
    ++(sign > 0 ? head_to_head.shoot_outs.won : head_to_head.shoot_outs.lost);
  }
  head_to_head.goals_for += first_left ? outcome.left_score : outcome.right_score;
  head_to_head.goals_against += first_left ? outcome.right_score : outcome.left_score;
}

}  // namespace

bool TeamRecord::paired() const { return total(pairs) > 0; }

Estimate TeamRecord::strength() const {
  if (paired()) return estimate(pairs);
  return estimate(games.score(), games.variance(), games.games());
}

std::vector<HeadToHead> head_to_heads(std::span<const ScheduledMatch> matches) {
  std::map<std::pair<int, int>, HeadToHead> all;
  std::map<int, OpenPair> pairings;
  for (const ScheduledMatch& match : matches) {
    const Fixture& fixture = match.fixture;
    const auto teams = std::minmax(fixture.left, fixture.right);
    OpenPair& pairing = pairings[fixture.pairing];
    ++pairing.matches;
    if (!match.outcome || !match.outcome->counts()) continue;
    HeadToHead& head_to_head = all[{teams.first, teams.second}];
    head_to_head.first = teams.first;
    head_to_head.second = teams.second;

    const int sign = winner_sign(*match.outcome);
    if (match.outcome->forfeit) {
      const bool first_won = (sign > 0) == (fixture.left == head_to_head.first);
      ++(first_won ? head_to_head.forfeits.won : head_to_head.forfeits.lost);
      continue;
    }
    add_game(head_to_head, match);
    ++pairing.played;
    pairing.half_points += half_points(fixture.left == head_to_head.first ? sign : -sign);
  }

  for (const ScheduledMatch& match : matches) {
    const OpenPair& pairing = pairings[match.fixture.pairing];
    if (!match.outcome || !match.outcome->played()) continue;
    HeadToHead& head_to_head = all[std::minmax(match.fixture.left, match.fixture.right)];
    const bool complete = pairing.matches == 2 && pairing.played == 2;
    if (!complete) {
      ++head_to_head.single_games;
    } else if (match.fixture.left == head_to_head.first) {  // once for the two matches
      head_to_head.pairs[base::index(pairing.half_points)] += 1;
    }
  }

  std::vector<HeadToHead> result;
  for (auto& [teams, head_to_head] : all) result.push_back(std::move(head_to_head));
  return result;
}

HeadToHead reversed(const HeadToHead& head_to_head) {
  HeadToHead other = head_to_head;
  std::swap(other.first, other.second);
  std::swap(other.games.won, other.games.lost);
  std::swap(other.goals_for, other.goals_against);
  std::swap(other.shoot_outs.won, other.shoot_outs.lost);
  std::swap(other.forfeits.won, other.forfeits.lost);
  std::ranges::reverse(other.pairs);
  return other;
}

TeamRecord record_of(int team, std::span<const HeadToHead> head_to_heads) {
  TeamRecord record;
  for (const HeadToHead& head_to_head : head_to_heads) {
    if (head_to_head.first != team && head_to_head.second != team) continue;
    const TeamRecord one = head_to_head.first == team ? head_to_head : reversed(head_to_head);
    record.games.won += one.games.won;
    record.games.drawn += one.games.drawn;
    record.games.lost += one.games.lost;
    record.single_games += one.single_games;
    for (std::size_t i = 0; i < record.pairs.size(); ++i) record.pairs[i] += one.pairs[i];
  }
  return record;
}

std::vector<PairResults> results_of(std::span<const HeadToHead> head_to_heads) {
  std::vector<PairResults> results;
  for (const HeadToHead& head_to_head : head_to_heads) {
    const WinDrawLoss& games = head_to_head.games;
    results.push_back({head_to_head.first, head_to_head.second, games.won + games.drawn / 2.0,
                       static_cast<double>(games.games())});
  }
  return results;
}

}  // namespace cls::league
