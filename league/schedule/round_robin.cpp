// Round robin, gauntlet, list and groups.
#include <fmt/format.h>

#include <algorithm>

#include "league/schedule/fixture_list.h"

namespace cls::league {
namespace {

void schedule_everyone(FixtureList& list, std::span<const int> teams, std::string_view stage) {
  const auto days = circle_rounds(teams);
  for (int round = 1; round <= rounds_of(list.competition()); ++round) {
    for (const auto& day : days) {
      for (const auto& [first, second] : day) {
        list.add_pairing(round, stage, first, second, round % 2 == 0);
      }
    }
  }
}

std::vector<ScheduledMatch> group_matches(std::span<const ScheduledMatch> so_far) {
  std::vector<ScheduledMatch> found;
  std::ranges::copy_if(so_far, std::back_inserter(found), [](const ScheduledMatch& match) {
    return match.fixture.stage.starts_with("group ");
  });
  return found;
}

// Team indices by group, assigned in serpentine order of the seeding.
std::vector<std::vector<int>> groups_of(const Competition& competition) {
  const std::vector<int> order = seeding(competition);
  const std::vector<std::optional<int>> slots(order.begin(), order.end());
  return serpentine(slots, base::index(competition.groups));
}

// Seeds of the knockout: all group winners, then all second, ... Those that have left make room.
std::vector<int> qualified(const Competition& competition, std::span<const RankedTable> groups,
                           const std::vector<int>& withdrawn) {
  std::vector<std::vector<int>> teams;
  for (const RankedTable& group : groups) {
    teams.emplace_back();
    for (const Standing& row : group.standings) {
      if (std::ranges::count(withdrawn, row.team) == 0) teams.back().push_back(row.team);
    }
  }

  std::vector<int> seeds;
  for (std::size_t place = 0; place < base::index(competition.advance); ++place) {
    for (const std::vector<int>& group : teams) {
      if (place < group.size()) seeds.push_back(group[place]);
    }
  }
  return seeds;
}

// The matches before the knockout; all while there is none.
std::span<const ScheduledMatch> before_knockout(std::span<const ScheduledMatch> matches) {
  const auto first = std::ranges::find_if_not(matches, [](const ScheduledMatch& match) {
    return match.fixture.stage.starts_with("group ");
  });
  return matches.first(base::index(first - matches.begin()));
}

}  // namespace

Progress schedule_round_robin(FixtureList& list) {
  schedule_everyone(list, seeding(list.competition()), "");
  return {};
}

// Every subject against all other teams; each pair of subjects once.
Progress schedule_gauntlet(FixtureList& list) {
  const Competition& competition = list.competition();
  const int teams = competition.team_count();
  const auto is_subject = [&](int team) {
    return std::ranges::count(competition.gauntlet, competition.team(team)) > 0;
  };

  for (int round = 1; round <= rounds_of(competition); ++round) {
    for (int subject = 0; subject < teams; ++subject) {
      if (!is_subject(subject)) continue;
      for (int other = 0; other < teams; ++other) {
        if (other == subject || (is_subject(other) && other < subject)) continue;
        list.add_pairing(round, "", subject, other, round % 2 == 0);
      }
    }
  }
  return {};
}

Progress schedule_list(FixtureList& list) {
  const Competition& competition = list.competition();
  for (int round = 1; round <= rounds_of(competition); ++round) {
    for (const auto& pairing : competition.matches) {
      list.add_pairing(round, "", team_index(competition, pairing[0]),
                       team_index(competition, pairing[1]));
    }
  }
  return {};
}

Progress schedule_groups(FixtureList& list) {
  const Competition& competition = list.competition();
  const std::vector<ScheduledMatch> played = group_matches(list.so_far());
  const auto groups = groups_of(competition);

  Progress progress;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (played.empty()) schedule_everyone(list, groups[i], group_name(i));
    progress.tables.push_back(
        {group_name(i), standings(groups[i], played, tie_breakers_of(competition))});
  }

  if (!played.empty() && all_have_outcomes(played)) {
    const auto orders = decided_orders(list.so_far());
    const std::vector<int> withdrawn = withdrawn_teams(before_knockout(list.so_far()));
    const int places = competition.advance + static_cast<int>(withdrawn.size());
    for (RankedTable& table : progress.tables) {
      draw_lots(competition.seed, table.title, places, orders, table.standings);
    }
    progress.ranks = schedule_knockout(list, qualified(competition, progress.tables, withdrawn),
                                       rounds_of(competition) + 1);
  }
  return progress;
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

std::vector<std::vector<std::pair<int, int>>> circle_rounds(std::span<const int> teams) {
  std::vector<int> seats(teams.begin(), teams.end());
  if (seats.size() % 2 == 1) seats.push_back(-1);
  const std::size_t count = seats.size();

  std::vector<std::vector<std::pair<int, int>>> rounds;
  for (std::size_t round = 0; round + 1 < count; ++round) {
    rounds.emplace_back();
    for (std::size_t k = 0; k < count / 2; ++k) {
      std::pair<int, int> pair(seats[k], seats[count - 1 - k]);
      if (pair.first < 0 || pair.second < 0) continue;
      // The first seat is fixed, so its sides alternate by round; other teams change seats.
      if (k == 0 ? round % 2 == 1 : k % 2 == 1) std::swap(pair.first, pair.second);
      rounds.back().push_back(pair);
    }
    std::rotate(seats.begin() + 1, seats.end() - 1, seats.end());
  }
  return rounds;
}

}  // namespace cls::league
