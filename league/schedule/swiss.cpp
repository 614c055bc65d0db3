// The Swiss system: each round pairs teams with similar points.
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "league/schedule/fixture_list.h"

namespace cls::league {
namespace {

constexpr int kMaxSteps = 200'000;

struct Entry {
  int team = 0;
  int points = 0;
};

/// Numbers of pairings of two teams.
using Meetings = std::map<std::pair<int, int>, int>;
using Pairs = std::vector<std::pair<int, int>>;

class Pairing {
 public:
  /// `ordered`: by points, then seeding. `meetings`: numbers of earlier pairings of two teams.
  Pairing(std::vector<Entry> ordered, const Meetings& meetings, int allowed_meetings)
      : ordered_(std::move(ordered)), meetings_(meetings), allowed_(allowed_meetings) {}

  bool solve() { return solve_rest(std::vector<bool>(ordered_.size(), false)); }
  const Pairs& pairs() const { return pairs_; }

 private:
  bool may_meet(std::size_t a, std::size_t b) const {
    const auto met = meetings_.find(std::minmax(ordered_[a].team, ordered_[b].team));
    return met == meetings_.end() || met->second <= allowed_;
  }

  // Opponents of the team at `first` in order of preference. Among equal points the upper half
  // plays the lower half in order; then follow the rest of the group and the teams with fewer
  // points.
  std::vector<std::size_t> candidates(std::size_t first, const std::vector<bool>& taken) const {
    std::vector<std::size_t> group;
    std::vector<std::size_t> below;
    for (std::size_t i = first; i < ordered_.size(); ++i) {
      if (taken[i]) continue;
      (ordered_[i].points == ordered_[first].points ? group : below).push_back(i);
    }

    const std::size_t half = group.size() / 2;
    std::vector<std::size_t> wanted;
    if (half > 0) wanted.assign(group.begin() + static_cast<long>(half), group.end());
    for (std::size_t i = half; i-- > 1;) wanted.push_back(group[i]);
    wanted.insert(wanted.end(), below.begin(), below.end());
    return wanted;
  }

  bool solve_rest(std::vector<bool> taken) {
    const auto open = std::ranges::find(taken, false);
    if (open == taken.end()) return true;
    if (++steps_ > kMaxSteps) return false;

    const auto first = static_cast<std::size_t>(open - taken.begin());
    for (const std::size_t other : candidates(first, taken)) {
      if (!may_meet(first, other)) continue;
      std::vector<bool> next = taken;
      next[first] = next[other] = true;
      pairs_.emplace_back(ordered_[first].team, ordered_[other].team);
      if (solve_rest(std::move(next))) return true;
      pairs_.pop_back();
    }
    return false;
  }

  std::vector<Entry> ordered_;
  const Meetings& meetings_;
  int allowed_;
  int steps_ = 0;
  Pairs pairs_;
};

// With an odd number of teams one gets a bye: of the teams with the fewest byes, which are none
// unless teams have left, the last one for which the others can be paired.
Pairs pair_round(const std::vector<Entry>& ordered, const std::map<int, int>& byes,
                 const Meetings& meetings) {
  const auto byes_of = [&byes](const Entry& entry) {
    return byes.contains(entry.team) ? byes.at(entry.team) : 0;
  };
  const int fewest = byes_of(std::ranges::min(ordered, {}, byes_of));
  for (int allowed = 0;; ++allowed) {
    if (ordered.size() % 2 == 0) {
      Pairing pairing(ordered, meetings, allowed);
      if (pairing.solve()) return pairing.pairs();
      continue;
    }
    for (std::size_t i = ordered.size(); i-- > 0;) {
      if (byes_of(ordered[i]) > fewest) continue;
      std::vector<Entry> rest = ordered;
      rest.erase(rest.begin() + static_cast<long>(i));
      Pairing pairing(std::move(rest), meetings, allowed);
      if (pairing.solve()) return pairing.pairs();
    }
  }
}

std::map<int, std::vector<ScheduledMatch>> by_round(std::span<const ScheduledMatch> matches) {
  std::map<int, std::vector<ScheduledMatch>> rounds;
  for (const ScheduledMatch& match : matches) rounds[match.fixture.round].push_back(match);
  return rounds;
}

struct History {
  Meetings meetings;
  std::map<int, int> lefts;  // matches that a team began on the left

  int lefts_of(int team) const { return lefts.contains(team) ? lefts.at(team) : 0; }
};

History history_of(std::span<const ScheduledMatch> matches) {
  History history;
  std::set<int> counted;
  for (const ScheduledMatch& match : matches) {
    const Fixture& fixture = match.fixture;
    ++history.lefts[fixture.left];
    if (!counted.insert(fixture.pairing).second) continue;
    ++history.meetings[std::minmax(fixture.left, fixture.right)];
  }
  return history;
}

// All teams but those that have left, by points, then seeding.
std::vector<Entry> entries_by_points(const FixtureList& list, const std::vector<Bye>& byes) {
  const std::vector<int> order = seeding(list.competition());
  std::map<int, int> points;
  for (const Standing& standing : standings(order, list.so_far(), {}, byes)) {
    points[standing.team] = standing.points;
  }

  const std::vector<int> withdrawn = withdrawn_teams(list.so_far());
  std::vector<Entry> ordered;
  for (const int team : order) {
    if (std::ranges::count(withdrawn, team) == 0) ordered.push_back({team, points[team]});
  }
  std::ranges::stable_sort(ordered, std::greater(), &Entry::points);
  return ordered;
}

}  // namespace

std::vector<Bye> swiss_byes(const Competition& competition,
                            std::span<const ScheduledMatch> so_far) {
  std::vector<Bye> byes;
  std::size_t known = 0;  // matches of earlier rounds
  for (const auto& [round, matches] : by_round(so_far)) {
    const std::vector<int> withdrawn = withdrawn_teams(so_far.first(known));
    std::set<int> present(withdrawn.begin(), withdrawn.end());
    known += matches.size();
    for (const ScheduledMatch& match : matches) {
      present.insert({match.fixture.left, match.fixture.right});
    }
    for (int team = 0; team < competition.team_count(); ++team) {
      if (!present.contains(team)) byes.push_back({team, competition.swap_sides ? 2 : 1, round});
    }
  }
  return byes;
}

Progress schedule_swiss(FixtureList& list) {
  const Competition& competition = list.competition();
  const auto so_far = list.so_far();
  const int round = static_cast<int>(by_round(so_far).size()) + 1;
  if (!all_have_outcomes(so_far) || round > rounds_of(competition)) return {};

  const std::vector<Bye> byes = swiss_byes(competition, so_far);
  const std::vector<Entry> entries = entries_by_points(list, byes);
  if (entries.size() < 2) return {};
  std::map<int, int> had_byes;
  for (const Bye& bye : byes) ++had_byes[bye.team];

  const History history = history_of(so_far);
  for (const auto& [first, second] : pair_round(entries, had_byes, history.meetings)) {
    const int more_lefts = history.lefts_of(first) - history.lefts_of(second);
    const bool swapped = more_lefts != 0 ? more_lefts > 0 : round % 2 == 0;
    list.add_pairing(round, "", first, second, swapped);
  }
  return {};
}

}  // namespace cls::league
