// Round robin, gauntlet, list and groups; knockout.cpp and swiss.cpp hold the other formats.
#include "tournament/schedule/schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "soccer/random.h"
#include "tournament/schedule/fixture_list.h"

namespace cls::tournament {
namespace {

using Ranks = std::vector<std::vector<int>>;

bool all_have_outcomes(std::span<const ScheduledMatch> matches) {
  return std::all_of(matches.begin(), matches.end(),
                     [](const ScheduledMatch& match) { return match.outcome.has_value(); });
}

void schedule_round_robin(FixtureList& list, std::span<const int> teams, std::string_view stage) {
  const auto days = circle_rounds(teams);
  for (int round = 1; round <= rounds_of(list.config()); ++round) {
    for (const auto& day : days) {
      for (const auto& [first, second] : day) {
        list.add_pairing(round, stage, first, second, round % 2 == 0);
      }
    }
  }
}

// Every subject against all other teams; each pair of subjects once.
void schedule_gauntlet(FixtureList& list) {
  const TournamentConfig& config = list.config();
  const int teams = static_cast<int>(config.teams.size());
  const auto is_subject = [&](int team) {
    const std::string& wanted = config.teams[static_cast<std::size_t>(team)].name;
    return std::find(config.gauntlet.begin(), config.gauntlet.end(), wanted) !=
           config.gauntlet.end();
  };
  for (int round = 1; round <= rounds_of(config); ++round) {
    for (int subject = 0; subject < teams; ++subject) {
      if (!is_subject(subject)) continue;
      for (int other = 0; other < teams; ++other) {
        if (other == subject || (is_subject(other) && other < subject)) continue;
        list.add_pairing(round, "", subject, other, round % 2 == 0);
      }
    }
  }
}

void schedule_list(FixtureList& list) {
  const TournamentConfig& config = list.config();
  for (int round = 1; round <= rounds_of(config); ++round) {
    for (const auto& pairing : config.matches) {
      list.add_pairing(round, "", team_index(config, pairing[0]), team_index(config, pairing[1]));
    }
  }
}

std::vector<ScheduledMatch> group_matches(std::span<const ScheduledMatch> so_far) {
  std::vector<ScheduledMatch> found;
  for (const ScheduledMatch& match : so_far) {
    if (match.fixture.stage.starts_with("group ")) found.push_back(match);
  }
  return found;
}

std::vector<std::vector<Standing>> group_tables(const TournamentConfig& config,
                                                std::span<const ScheduledMatch> so_far) {
  const std::vector<ScheduledMatch> matches = group_matches(so_far);
  std::vector<std::vector<Standing>> all;
  for (const std::vector<int>& group : groups_of(config)) {
    all.push_back(standings(group, matches, tie_breakers_of(config)));
  }
  return all;
}

// Seeds of the knockout: all group winners, then all second, ...
std::vector<int> qualified(const TournamentConfig& config, std::span<const ScheduledMatch> so_far) {
  const auto groups = group_tables(config, so_far);
  std::vector<int> seeds;
  for (std::size_t place = 0; place < static_cast<std::size_t>(config.advance); ++place) {
    for (const auto& group : groups) {
      if (place < group.size()) seeds.push_back(group[place].team);
    }
  }
  return seeds;
}

Ranks schedule_groups(FixtureList& list) {
  const TournamentConfig& config = list.config();
  const std::vector<ScheduledMatch> played = group_matches(list.so_far());
  if (played.empty()) {
    const auto groups = groups_of(config);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      schedule_round_robin(list, groups[i], group_name(i));
    }
    return {};
  }
  if (!all_have_outcomes(played)) return {};
  return schedule_knockout(list, qualified(config, list.so_far()), rounds_of(config) + 1);
}

Ranks run_format(FixtureList& list) {
  const TournamentConfig& config = list.config();
  const bool first_call = list.so_far().empty();
  switch (config.format) {
    case Format::kRoundRobin:
      if (first_call) schedule_round_robin(list, seeding(config), "");
      return {};
    case Format::kGauntlet:
      if (first_call) schedule_gauntlet(list);
      return {};
    case Format::kList:
      if (first_call) schedule_list(list);
      return {};
    case Format::kGroups:
      return schedule_groups(list);
    case Format::kKnockout:
      return schedule_knockout(list, seeding(config), 1);
    case Format::kDoubleElimination:
      return schedule_double_elimination(list, seeding(config));
    case Format::kSwiss:
      schedule_swiss(list);
      return {};
    case Format::kStages:
      schedule_stages(list);
      return {};
  }
  return {};
}

}  // namespace

std::vector<Standing> order_by_rank(const Ranks& ranks, const std::vector<Standing>& table) {
  std::map<int, Standing> by_team;
  for (const Standing& standing : table) by_team[standing.team] = standing;
  std::vector<Standing> ordered;
  for (const std::vector<int>& shared : ranks) {
    const int rank = static_cast<int>(ordered.size()) + 1;
    for (const int team : shared) {
      ordered.push_back(by_team.at(team));
      ordered.back().rank = rank;
      ordered.back().separated_by.clear();
    }
  }
  return ordered;
}

std::string group_name(std::size_t group) {
  return group < 26 ? fmt::format("group {}", static_cast<char>('A' + group))
                    : fmt::format("group {}", group + 1);
}

std::vector<std::vector<int>> serpentine(std::span<const std::optional<int>> order,
                                         std::size_t groups) {
  std::vector<std::vector<int>> result(groups);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t turn = i / groups;
    const std::size_t step = i % groups;
    if (order[i]) result[turn % 2 == 0 ? step : groups - 1 - step].push_back(*order[i]);
  }
  return result;
}

std::vector<std::vector<int>> groups_of(const TournamentConfig& config) {
  const std::vector<int> order = seeding(config);
  const std::vector<std::optional<int>> slots(order.begin(), order.end());
  return serpentine(slots, static_cast<std::size_t>(config.groups));
}

std::vector<Fixture> next_fixtures(const TournamentConfig& config,
                                   std::span<const ScheduledMatch> so_far) {
  FixtureList list(config, so_far);
  run_format(list);
  return list.take();
}

std::vector<RankedTable> tables(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far) {
  FixtureList list(config, so_far);
  if (config.format == Format::kStages) return schedule_stages(list);
  const std::vector<int> order = seeding(config);
  const auto breakers = tie_breakers_of(config);
  std::vector<RankedTable> result;
  std::vector<Bye> byes;
  if (config.format == Format::kSwiss) byes = swiss_byes(config, so_far);
  if (config.format == Format::kGroups) {
    auto groups = group_tables(config, so_far);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      result.push_back({group_name(i), std::move(groups[i])});
    }
  }
  const bool has_ranks = config.format == Format::kGroups || config.format == Format::kKnockout ||
                         config.format == Format::kDoubleElimination;
  const Ranks ranks = has_ranks ? run_format(list) : Ranks();
  if (!ranks.empty()) {
    result.push_back({"knock-out", order_by_rank(ranks, standings(order, so_far, breakers, byes))});
  } else if (result.empty()) {
    result.push_back({"", standings(order, so_far, breakers, byes)});
  }
  return result;
}

std::vector<BracketTie> bracket(const TournamentConfig& config,
                                std::span<const ScheduledMatch> so_far) {
  if (so_far.empty()) return {};
  FixtureList list(config, so_far);
  run_format(list);
  return list.take_bracket();
}

std::uint64_t pairing_seed(std::uint64_t tournament_seed, int pairing) {
  constexpr std::uint64_t kMask = 0x7fffffff;
  soccer::RandomStream random(tournament_seed, "match seeds");
  const std::uint64_t offset = random.next() % kMask;
  const std::uint64_t key = random.next() & kMask;
  // Every step is a bijection, so distinct pairings have distinct seeds.
  const auto mix = [key](std::uint64_t x) {
    x ^= key;
    x ^= x >> 15;
    x = x * 0x2c1b3c6d & kMask;
    x ^= x >> 12;
    x = x * 0x297a2d39 & kMask;
    return x ^ x >> 15;
  };
  std::uint64_t seed = mix(1 + (static_cast<std::uint64_t>(pairing) + offset) % kMask);
  while (seed == 0) seed = mix(seed);
  return seed;
}

}  // namespace cls::tournament
