// A competition as plain data: who plays whom, and how a table is ordered.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/index.h"
#include "base/text/enum_names.h"
#include "league/competition/stage.h"

namespace cls::league {

/// league/schedule/formats.h has their names and rules.
enum class Format {
  kRoundRobin,         ///< every team against every other
  kGauntlet,           ///< some teams (`gauntlet`) against all others
  kList,               ///< the pairings of `matches`
  kGroups,             ///< round robin in groups, then a knockout of the best
  kKnockout,           ///< single elimination
  kDoubleElimination,  ///< elimination by the second loss
  kSwiss,              ///< pairs teams with similar points, never the same pair twice
  kStages,             ///< the `stages`, one after the other
};

/// Criteria that order teams with the same points, see standings.h.
enum class TieBreaker {
  kHeadToHead,
  kGoalDifference,
  kGoalDifferenceAmong,  ///< among the tied teams only
  kGoals,
  kGoalsAmong,
  kWins,
  kBuchholz,
  kMedianBuchholz,
  kSonnebornBerger,
};

inline constexpr auto kTieBreakers = base::enum_names<TieBreaker>(
    "head-to-head", "goal-difference", "goal-difference-among", "goals", "goals-among", "wins",
    "buchholz", "median-buchholz", "sonneborn-berger");

constexpr std::string_view name(TieBreaker breaker) { return kTieBreakers.name(breaker); }

struct TeamEntry {
  std::string name;
  std::string endpoint;  ///< any SIDE of `cls match` except a name

  bool operator==(const TeamEntry&) const = default;
};

struct Competition {
  Format format = Format::kRoundRobin;
  std::optional<int> rounds;  ///< see rounds_of()
  std::uint64_t seed = 1;     ///< all seeds and draws follow from it
  bool swap_sides = true;     ///< every pairing is two matches on one seed, once from each side
  bool draw = false;          ///< random seeding order instead of the order of `teams`
  std::vector<std::string> gauntlet;
  std::vector<std::vector<std::string>> matches;  ///< kList: two team names each
  int groups = 2;
  int advance = 2;  ///< teams of each group that advance to the knockout
  bool third_place = true;
  std::vector<TieBreaker> tie_breakers;  ///< empty: those of the format
  std::vector<Stage> stages;             ///< kStages
  std::vector<TeamEntry> teams;          ///< in the order of the file

  /// The name of the team at `index`.
  const std::string& team(int index) const { return teams[base::index(index)].name; }
  int team_count() const { return static_cast<int>(teams.size()); }
};

/// The names of teams, with commas between them.
inline std::string team_list(const Competition& competition, std::span<const int> teams) {
  std::string text;
  for (const int team : teams) text += (text.empty() ? "" : ", ") + competition.team(team);
  return text;
}

/// Index of the team `name`, or -1.
inline int team_index(const Competition& competition, std::string_view name) {
  const auto found = std::ranges::find(competition.teams, name, &TeamEntry::name);
  return found == competition.teams.end() ? -1
                                          : static_cast<int>(found - competition.teams.begin());
}

}  // namespace cls::league
