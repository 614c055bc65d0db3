// Counts points and goals, and orders tied teams recursively.
#include "league/schedule/standings.h"

#include <algorithm>
#include <climits>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "base/text/fnv1a.h"
#include "soccer/random.h"

namespace cls::league {

namespace {

constexpr int kWinPoints = 3;

int points_for(int sign) { return sign > 0 ? kWinPoints : sign == 0 ? 1 : 0; }

// Results of a team against one opponent.
struct OpponentRecord {
  int matches = 0;
  int points = 0;
  int wins = 0;
  int draws = 0;
  int goals_for = 0;
  int goals_against = 0;
};

using OpponentRecords = std::map<std::pair<int, int>, OpponentRecord>;

class Table {
 public:
  Table(std::span<const int> teams, std::span<const ScheduledMatch> matches,
        std::span<const Bye> byes) {
    for (const int team : teams) {
      rows_.emplace_back();
      rows_.back().team = team;
      place_[team] = rows_.size() - 1;
    }

    std::vector<ScheduledMatch> counted;
    for (const ScheduledMatch& match : matches) {
      if (add(match)) counted.push_back(match);
    }
    const std::vector<HeadToHead> met = head_to_heads(counted);
    for (Standing& standing : rows_) standing.record = record_of(standing.team, met);

    for (const Bye& bye : byes) {
      if (!place_.contains(bye.team)) continue;
      ++row(bye.team).byes;
      row(bye.team).points += kWinPoints * bye.matches;
      bye_matches_[bye.team] += bye.matches;
    }
    add_opponents_points();
  }

  std::vector<Standing> ordered(const std::vector<TieBreaker>& breakers) {
    std::vector<int> all;
    for (const Standing& standing : rows_) all.push_back(standing.team);
    std::vector<Standing> result;
    const auto per_match = [this](int team) {
      const Standing& standing = row(team);
      const int count = standing.played + bye_matches_[team];
      return count == 0 ? 0.0 : static_cast<double>(standing.points) / count;
    };
    for (const std::vector<int>& level : split(all, per_match)) {
      order_tied(level, breakers, result);
    }
    return result;
  }

 private:
  using Value = std::function<double(int)>;

  Standing& row(int team) { return rows_[place_.at(team)]; }

  // False for a match without a result, for one that was annulled, and for one of other teams.
  bool add(const ScheduledMatch& match) {
    const Fixture& fixture = match.fixture;
    if (!match.outcome || !place_.contains(fixture.left) || !place_.contains(fixture.right)) {
      return false;
    }

    const Outcome& outcome = *match.outcome;
    if (outcome.annulled) return false;
    if (!outcome.counts()) {
      ++row(fixture.left).invalid;
      ++row(fixture.right).invalid;
      return true;
    }

    const int sign = winner_sign(outcome);
    add_side(fixture.left, fixture.right, sign, outcome.left_score, outcome.right_score);
    add_side(fixture.right, fixture.left, -sign, outcome.right_score, outcome.left_score);
    if (sign == 0) return true;

    Standing& winner = row(sign > 0 ? fixture.left : fixture.right);
    Standing& loser = row(sign > 0 ? fixture.right : fixture.left);
    if (outcome.forfeit) {
      ++winner.forfeits.won;
      ++loser.forfeits.lost;
    } else if (had_shoot_out(outcome)) {
      ++winner.shoot_outs.won;
      ++loser.shoot_outs.lost;
    }
    return true;
  }

  void add_side(int team, int opponent, int sign, int goals_for, int goals_against) {
    Standing& standing = row(team);
    ++standing.played;
    ++(sign > 0 ? standing.won : sign == 0 ? standing.drawn : standing.lost);
    standing.goals_for += goals_for;
    standing.goals_against += goals_against;
    standing.points += points_for(sign);

    OpponentRecord& met = records_[{team, opponent}];
    ++met.matches;
    met.wins += sign > 0;
    met.draws += sign == 0;
    met.points += points_for(sign);
    met.goals_for += goals_for;
    met.goals_against += goals_against;
  }

  void add_opponents_points() {
    for (Standing& standing : rows_) {
      std::vector<double> opponents;
      for (const auto& [teams, met] : records_) {
        if (teams.first != standing.team) continue;
        const double points = row(teams.second).points;
        opponents.insert(opponents.end(), base::index(met.matches), points);
        standing.sonneborn_berger += points * met.wins + points / 2 * met.draws;
      }
      for (const double points : opponents) standing.buchholz += points;
      if (opponents.size() > 2) {
        const auto [low, high] = std::ranges::minmax(opponents);
        standing.median_buchholz = standing.buchholz - low - high;
      }
    }
  }

  // Classes of equal value, best first; the order within a class is stable.
  static std::vector<std::vector<int>> split(std::vector<int> teams, const Value& value) {
    std::vector<std::pair<double, int>> valued;
    for (const int team : teams) valued.emplace_back(value(team), team);
    std::ranges::stable_sort(valued, std::greater(), &std::pair<double, int>::first);

    std::vector<std::vector<int>> classes;
    for (std::size_t i = 0; i < valued.size(); ++i) {
      if (i == 0 || valued[i].first != valued[i - 1].first) classes.emplace_back();
      classes.back().push_back(valued[i].second);
    }
    return classes;
  }

  // Sum of a value of the records against the other tied teams.
  double among(int team, const std::vector<int>& tied,
               const std::function<double(const OpponentRecord&)>& value) const {
    double sum = 0.0;
    for (const int other : tied) {
      const auto found = records_.find({team, other});
      if (found != records_.end()) sum += value(found->second);
    }
    return sum;
  }

  bool beat(int team, int other) const {
    const auto own = records_.find({team, other});
    const auto other_record = records_.find({other, team});
    return own != records_.end() && other_record != records_.end() &&
           own->second.points > other_record->second.points;
  }

  Value value_of(TieBreaker breaker, const std::vector<int>& tied) {
    switch (breaker) {
      case TieBreaker::kHeadToHead:
        return [this, tied](int team) {
          return std::ranges::all_of(tied,
                                     [&](int other) { return other == team || beat(team, other); });
        };
      case TieBreaker::kGoalDifference:
        return [this](int team) { return per_match(team, row(team).goal_difference()); };
      case TieBreaker::kGoalDifferenceAmong:
        return [this, tied](int team) {
          return among(team, tied,
                       [](const OpponentRecord& d) { return d.goals_for - d.goals_against; });
        };
      case TieBreaker::kGoals:
        return [this](int team) { return per_match(team, row(team).goals_for); };
      case TieBreaker::kGoalsAmong:
        return [this, tied](int team) {
          return among(team, tied, [](const OpponentRecord& d) { return d.goals_for; });
        };
      case TieBreaker::kWins:
        return [this](int team) { return row(team).won; };
      case TieBreaker::kBuchholz:
        return [this](int team) { return row(team).buchholz; };
      case TieBreaker::kMedianBuchholz:
        return [this](int team) { return row(team).median_buchholz; };
      case TieBreaker::kSonnebornBerger:
        return [this](int team) { return row(team).sonneborn_berger; };
    }
    return [](int) { return 0.0; };
  }

  double per_match(int team, int sum) {
    const int played = row(team).played;
    return played == 0 ? 0.0 : static_cast<double>(sum) / played;
  }

  void order_tied(const std::vector<int>& tied, const std::vector<TieBreaker>& breakers,
                  std::vector<Standing>& result) {
    if (tied.size() > 1) {
      for (const TieBreaker breaker : breakers) {
        const auto classes = split(tied, value_of(breaker, tied));
        if (classes.size() == 1) continue;
        for (std::size_t i = 0; i < classes.size(); ++i) {
          const std::size_t first = result.size();
          order_tied(classes[i], breakers, result);
          if (i > 0) result[first].separated_by = name(breaker);
        }
        return;
      }
    }

    const int rank = static_cast<int>(result.size()) + 1;
    for (const int team : tied) {
      result.push_back(row(team));
      result.back().rank = rank;
    }
  }

  std::vector<Standing> rows_;
  std::map<int, std::size_t> place_;
  std::map<int, int> bye_matches_;
  OpponentRecords records_;
};

// The place of the team in the last order that was decided for the table.
std::optional<int> decided_place(std::span<const MatchDecision> orders, std::string_view title,
                                 int team) {
  std::optional<int> place;
  for (const MatchDecision& order : orders) {
    const auto found = std::ranges::find(order.teams, team);
    if (order.table != title || found == order.teams.end()) continue;
    place = static_cast<int>(found - order.teams.begin());
  }
  return place;
}

}  // namespace

std::vector<Standing> standings(std::span<const int> teams, std::span<const ScheduledMatch> matches,
                                const std::vector<TieBreaker>& breakers,
                                std::span<const Bye> byes) {
  return Table(teams, matches, byes).ordered(breakers);
}

void draw_lots(std::uint64_t seed, std::string_view title, int places,
               std::span<const MatchDecision> orders, std::vector<Standing>& table) {
  const auto place_of = [&](const Standing& row) {
    const int lot = soccer::RandomStream(seed, "lot of a table", base::fnv1a(title),
                                         static_cast<std::uint64_t>(row.team))
                        .integer(1 << 30);
    return std::pair(decided_place(orders, title, row.team).value_or(INT_MAX), lot);
  };

  for (auto first = table.begin(); first != table.end();) {
    const int rank = first->rank;
    const auto end =
        std::find_if(first, table.end(), [rank](const Standing& row) { return row.rank != rank; });
    if (end - first > 1 && rank <= places) {
      std::stable_sort(first, end, [&](const Standing& a, const Standing& b) {
        return place_of(a) < place_of(b);
      });
      int next = rank;
      for (auto row = first; row != end; ++row) {
        const bool decided = place_of(*row).first != INT_MAX;
        if (row != first) row->separated_by = decided ? kDecision : kLot;
        row->rank = next++;
      }
    }
    first = end;
  }
}

}  // namespace cls::league
