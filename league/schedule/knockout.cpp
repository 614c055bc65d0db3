// Single and double elimination, and the brackets of stages. Each call walks the whole bracket:
// entrants that are not known yet stay unknown, and ties whose two teams are known get their
// matches.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>

#include "league/schedule/fixture_list.h"
#include "soccer/random.h"

namespace cls::league {
namespace {

constexpr int kMaxDeciders = 3;

struct Tie {
  Entrant winner;
  Entrant loser;
};

struct TieResult {
  int sign = 0;  // +1 when the first team wins, -1 when the second does, 0 while undecided
  bool by_lot = false;
};

// Points, then goals, over the matches that are not deciders.
int aggregate_sign(const std::vector<ScheduledMatch>& matches, int first) {
  int points = 0;
  int goals = 0;
  for (const ScheduledMatch& match : matches) {
    if (match.fixture.decides || !match.outcome->counts()) continue;
    const int side = match.fixture.left == first ? 1 : -1;
    points += side * winner_sign(*match.outcome);
    goals += side * (match.outcome->left_score - match.outcome->right_score);
  }
  const int sign = points != 0 ? points : goals;
  return sign > 0 ? 1 : sign < 0 ? -1 : 0;
}

// The last decider with a winner counts.
int decider_sign(const std::vector<ScheduledMatch>& matches, int first) {
  for (auto match = matches.rbegin(); match != matches.rend(); ++match) {
    if (!match->fixture.decides || !match->outcome->counts()) continue;
    const int sign = winner_sign(*match->outcome);
    if (sign != 0) return match->fixture.left == first ? sign : -sign;
  }
  return 0;
}

int draw_lot(const Competition& competition, const std::vector<ScheduledMatch>& matches) {
  const auto key = static_cast<std::uint64_t>(matches.front().fixture.pairing);
  soccer::RandomStream random(competition.seed, "lot", key);
  return random.integer(2) == 0 ? 1 : -1;
}

class Bracket {
 public:
  explicit Bracket(FixtureList& list) : list_(list) {}

  TieResult decide(int round, const std::string& stage, int first, int second) {
    const Competition& competition = list_.competition();
    const std::vector<ScheduledMatch> matches = list_.of_stage(stage);
    if (matches.empty()) {
      schedule(round, stage, first, second);
      return {};
    }
    if (!all_have_outcomes(matches)) return {};
    if (const int sign = decider_sign(matches, first)) return {sign};
    if (const int sign = aggregate_sign(matches, first)) return {sign};

    const auto deciders = std::ranges::count_if(
        matches, [](const ScheduledMatch& match) { return match.fixture.decides; });
    if (deciders >= kMaxDeciders) return {draw_lot(competition, matches), true};
    const bool swapped = deciders % 2 == 1;
    list_.add_decider(round, stage, swapped ? second : first, swapped ? first : second);
    return {};
  }

  // Plays a tie and records it. Who meets a bye wins.
  Tie tie(int round, const std::string& stage, const Entrant& first, const Entrant& second) {
    TieResult decision;
    if (first.bye || second.bye) {
      decision.sign = first.bye ? -1 : 1;
    } else if (first.team && second.team) {
      decision = decide(round, stage, *first.team, *second.team);
    }

    BracketTie record{round, stage, {first, second}, std::nullopt, decision.by_lot};
    Tie result;
    if (decision.sign != 0) {
      result = decision.sign > 0 ? Tie{first, second} : Tie{second, first};
      record.winner = result.winner.team;
    }

    result.winner.winner = true;
    result.loser.winner = false;
    result.winner.tie = result.loser.tie = list_.add_tie(std::move(record));
    return result;
  }

 private:
  void schedule(int round, const std::string& stage, int first, int second) {
    const Competition& competition = list_.competition();
    const int rounds = competition.format == Format::kGroups ? 1 : rounds_of(competition);
    if (!competition.swap_sides && rounds == 1) {
      list_.add_decider(round, stage, first, second);
      return;
    }
    for (int i = 0; i < rounds; ++i) list_.add_pairing(round, stage, first, second, i % 2 == 1);
  }

  FixtureList& list_;
};

// First seed against last, second against last but one, with the first two in different halves.
std::vector<Entrant> bracket_slots(const std::vector<int>& seeds) {
  std::vector<std::size_t> order = {0};
  while (order.size() < seeds.size()) {
    const std::size_t size = order.size() * 2;
    std::vector<std::size_t> next;
    for (const std::size_t seed : order) {
      next.push_back(seed);
      next.push_back(size - 1 - seed);
    }
    order = std::move(next);
  }

  std::vector<Entrant> slots;
  for (const std::size_t seed : order) {
    Entrant entrant;
    entrant.bye = seed >= seeds.size();
    if (!entrant.bye) entrant.team = seeds[seed];
    slots.push_back(entrant);
  }
  return slots;
}

std::string stage_name(std::size_t ties, std::size_t number) {
  if (ties == 1) return "final";
  if (ties == 2) return fmt::format("semi-final {}", number);
  if (ties == 4) return fmt::format("quarter-final {}", number);
  return fmt::format("last {}, tie {}", 2 * ties, number);
}

// By the rank of the defender.
std::string step_name(std::size_t rank) {
  if (rank == 1) return "final";
  if (rank == 2) return "semi-final";
  return fmt::format("rank {}", rank);
}

/// Teams in order of their elimination, from which the ranks follow in reverse.
class Eliminations {
 public:
  void add(std::vector<Entrant> together) {
    std::vector<int> teams;
    for (const Entrant& team : together) {
      if (team.team) teams.push_back(*team.team);
    }
    if (!teams.empty()) groups_.push_back(std::move(teams));
  }
  Ranks ranks(const std::vector<int>& seeds) const {
    std::vector<int> remaining;
    for (const int team : seeds) {
      const bool out = std::ranges::any_of(groups_, [team](const std::vector<int>& group) {
        return std::ranges::find(group, team) != group.end();
      });
      if (!out) remaining.push_back(team);
    }

    Ranks result;
    if (!remaining.empty()) result.push_back(remaining);
    result.insert(result.end(), groups_.rbegin(), groups_.rend());
    return result;
  }

 private:
  Ranks groups_;
};

// The winners or the losers.
std::vector<Entrant> entrants_of(const std::vector<Tie>& ties, Entrant Tie::*which) {
  std::vector<Entrant> entrants;
  std::ranges::transform(ties, std::back_inserter(entrants), which);
  return entrants;
}

// Adjacent entrants play each other.
std::vector<Tie> play_adjacent(Bracket& bracket, int round, const std::vector<Entrant>& slots,
                               const std::function<std::string(std::size_t)>& stage) {
  std::vector<Tie> ties;
  for (std::size_t i = 0; i + 1 < slots.size(); i += 2) {
    ties.push_back(bracket.tie(round, stage(i / 2 + 1), slots[i], slots[i + 1]));
  }
  return ties;
}

// The last rank plays the one above it, the winner the next.
Ranks schedule_stepladder(FixtureList& list, const std::vector<int>& seeds, int first_round) {
  Bracket bracket(list);
  Eliminations eliminated;
  Entrant climber;
  climber.team = seeds.back();
  for (std::size_t rank = seeds.size() - 1; rank > 0; --rank) {
    const int round = first_round + static_cast<int>(seeds.size() - 1 - rank);
    Entrant defender;
    defender.team = seeds[rank - 1];
    const Tie tie = bracket.tie(round, step_name(rank), defender, climber);
    eliminated.add({tie.loser});
    climber = tie.winner;
  }
  return eliminated.ranks(seeds);
}

// By StageFormat.
constexpr std::array<PlayBracket, kStageFormats.texts.size()> kBrackets = {
    nullptr, schedule_knockout, schedule_stepladder};

}  // namespace

Ranks schedule_knockout(FixtureList& list, const std::vector<int>& seeds, int first_round) {
  Bracket bracket(list);
  Eliminations eliminated;
  std::vector<Entrant> slots = bracket_slots(seeds);
  for (int round = first_round; slots.size() > 1; ++round) {
    const std::size_t ties = slots.size() / 2;
    const std::vector<Tie> played = play_adjacent(
        bracket, round, slots, [ties](std::size_t number) { return stage_name(ties, number); });
    const std::vector<Entrant> losers = entrants_of(played, &Tie::loser);

    if (ties == 2 && list.competition().third_place) {
      const Tie third = bracket.tie(round + 1, "third place", losers[0], losers[1]);
      if (third.winner.team) {
        eliminated.add({third.loser});
        eliminated.add({third.winner});
      } else {
        eliminated.add(losers);
      }
    } else {
      eliminated.add(losers);
    }

    slots = entrants_of(played, &Tie::winner);
  }
  return eliminated.ranks(seeds);
}

Progress schedule_single_elimination(FixtureList& list) {
  return {{}, schedule_knockout(list, seeding(list.competition()), 1)};
}

Progress schedule_double_elimination(FixtureList& list) {
  const std::vector<int> seeds = seeding(list.competition());
  Bracket bracket(list);
  Eliminations eliminated;
  const auto losers_round = [&](int round, const std::vector<Entrant>& slots, int number) {
    const std::vector<Tie> played = play_adjacent(bracket, round, slots, [number](std::size_t tie) {
      return fmt::format("losers' round {}, tie {}", number, tie);
    });
    eliminated.add(entrants_of(played, &Tie::loser));
    return entrants_of(played, &Tie::winner);
  };

  std::vector<Entrant> upper = bracket_slots(seeds);
  std::vector<Entrant> lower;
  int lower_rounds = 0;
  for (int round = 1; upper.size() > 1; ++round) {
    const std::vector<Tie> played = play_adjacent(bracket, round, upper, [round](std::size_t tie) {
      return fmt::format("winners' round {}, tie {}", round, tie);
    });
    upper = entrants_of(played, &Tie::winner);
    std::vector<Entrant> dropped = entrants_of(played, &Tie::loser);

    if (round == 1) {
      lower = std::move(dropped);
    } else {
      // Reversed, so that teams from the same half of the winners' bracket meet again late.
      std::ranges::reverse(dropped);
      std::vector<Entrant> mixed;
      for (std::size_t i = 0; i < lower.size(); ++i) {
        mixed.push_back(lower[i]);
        mixed.push_back(dropped[i]);
      }
      lower = losers_round(round + 1, mixed, ++lower_rounds);
    }
    if (lower.size() > 1) lower = losers_round(round + 1, lower, ++lower_rounds);
  }

  const int last_round = lower_rounds + 2;
  const Entrant undefeated = upper.front();
  const Entrant challenger = lower.empty() ? Entrant{std::nullopt, true} : lower.front();
  const Tie first = bracket.tie(last_round, "grand final", undefeated, challenger);
  if (first.winner.team && first.winner.team == undefeated.team) {
    eliminated.add({first.loser});
  } else if (first.winner.team) {
    eliminated.add(
        {bracket.tie(last_round + 1, "grand final, second", undefeated, challenger).loser});
  }
  return {{}, eliminated.ranks(seeds)};
}

PlayBracket bracket_of(StageFormat format) { return kBrackets[base::index(format)]; }

}  // namespace cls::league
