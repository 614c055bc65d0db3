// One call for all formats, see formats.cpp.
#include "league/schedule/schedule.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <vector>

#include "league/schedule/fixture_list.h"

namespace cls::league {
namespace {

Progress run_format(FixtureList& list) {
  const FormatRules& rules = rules_of(list.competition());
  if (!rules.later && !list.so_far().empty()) return {};
  return rules.schedule(list);
}

// The matches that are in no table of a group.
std::vector<ScheduledMatch> outside_of(std::span<const RankedTable> groups,
                                       std::span<const ScheduledMatch> matches) {
  std::vector<ScheduledMatch> others;
  std::ranges::copy_if(matches, std::back_inserter(others), [&](const ScheduledMatch& match) {
    return std::ranges::find(groups, match.fixture.stage, &RankedTable::title) == groups.end();
  });
  return others;
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

std::vector<Fixture> next_fixtures(const Competition& competition,
                                   std::span<const ScheduledMatch> so_far) {
  FixtureList list(competition, so_far);
  run_format(list);
  return list.take();
}

std::vector<RankedTable> tables(const Competition& competition,
                                std::span<const ScheduledMatch> so_far) {
  FixtureList list(competition, so_far);
  Progress progress = run_format(list);
  const bool ranked = !progress.ranks.empty();
  if (!progress.tables.empty() && !ranked) return std::move(progress.tables);

  const bool stages = competition.format == Format::kStages;
  const auto played = stages ? std::vector<ScheduledMatch>(so_far.begin(), so_far.end())
                             : outside_of(progress.tables, so_far);
  std::vector<Standing> table = standings(seeding(competition), played,
                                          tie_breakers_of(competition), byes(competition, so_far));
  if (ranked) table = order_by_rank(progress.ranks, table);
  const char* title = stages ? "ranking" : "knock-out";
  progress.tables.push_back({ranked ? title : "", std::move(table)});
  return std::move(progress.tables);
}

std::vector<EqualTeams> equal_teams(const Competition& competition,
                                    std::span<const ScheduledMatch> so_far) {
  std::vector<EqualTeams> found;
  for (const RankedTable& table : tables(competition, so_far)) {
    const Standing* above = nullptr;
    for (const Standing& row : table.standings) {
      const bool equal = row.separated_by == kLot || row.separated_by == kDecision;
      if (equal && above->separated_by != kLot && above->separated_by != kDecision) {
        found.push_back({.table = table.title, .teams = {above->team}});
      }
      if (equal) {
        found.back().teams.push_back(row.team);
        found.back().decided = row.separated_by == kDecision;
      }
      above = &row;
    }
  }
  return found;
}

std::vector<Bye> byes(const Competition& competition, std::span<const ScheduledMatch> so_far) {
  const auto byes = rules_of(competition).byes;
  return byes == nullptr ? std::vector<Bye>() : byes(competition, so_far);
}

std::vector<BracketTie> bracket(const Competition& competition,
                                std::span<const ScheduledMatch> so_far) {
  if (so_far.empty()) return {};
  FixtureList list(competition, so_far);
  run_format(list);
  return list.take_bracket();
}

}  // namespace cls::league
