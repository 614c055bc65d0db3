// The rules of the formats of competitions: one table, from which all else follows.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "league/competition/competition.h"
#include "league/competition/error_list.h"
#include "league/schedule/standings.h"

namespace cls::league {

class FixtureList;

/// Teams of one element share a rank, best first.
using Ranks = std::vector<std::vector<int>>;

/// A table of a competition: of a group, of all teams, of a knockout, or the ranking after all
/// stages, which counts the matches of all of them.
struct RankedTable {
  std::string title;  ///< "", "group A", "knock-out", "ranking"
  std::vector<Standing> standings;
  bool average = false;  ///< its teams have played different numbers of matches
};

/// The state of a competition after the matches so far.
struct Progress {
  std::vector<RankedTable> tables;  ///< of groups and stages
  Ranks ranks;                      ///< of a knockout, as far as they are known
};

/// The default order of teams with the same points: that of the league
/// (docs/spec/match-statistics.md 10), without its deciding shoot-out.
inline constexpr TieBreaker kLeagueOrder[] = {TieBreaker::kHeadToHead, TieBreaker::kGoalDifference,
                                              TieBreaker::kGoalDifferenceAmong, TieBreaker::kGoals,
                                              TieBreaker::kGoalsAmong};

struct FormatRules {
  Format format;
  std::string_view name;  ///< in the configuration file
  /// Appends the matches that can be played next.
  Progress (*schedule)(FixtureList& list);
  /// The errors of a competition of this format.
  void (*check)(ErrorList& errors, const Competition& competition) = nullptr;
  /// About how many matches it has; null: few enough.
  double (*size)(const Competition& competition) = nullptr;
  /// The default of `rounds`; null: 1.
  int (*rounds)(const Competition& competition) = nullptr;
  /// The byes so far; null: there are none, or they are part of the bracket.
  std::vector<Bye> (*byes)(const Competition& competition,
                           std::span<const ScheduledMatch> so_far) = nullptr;
  std::span<const TieBreaker> tie_breakers = kLeagueOrder;
  bool later = true;             ///< further matches follow from results
  bool bracket_only = false;     ///< the bracket says all that a crosstable would
  bool shows_opponents = false;  ///< opponents differ, so tables show their points (Buchholz)
  bool adds_shoot_outs = false;  ///< shoot-outs are written as the league does: (2+4) - (2+3)
};

/// In the order of Format.
std::span<const FormatRules> formats();
const FormatRules& rules_of(const Competition& competition);

/// "round-robin", "double-elimination", ...
std::string_view name(Format format);

/// The configured rounds, or the default: 1; Swiss: ceil(log2(teams)) + 1, limited so that no teams
/// meet twice.
int rounds_of(const Competition& competition);

/// The configured tiebreakers, or the default ones of the format.
std::vector<TieBreaker> tie_breakers_of(const Competition& competition);

/// All contradictions and invalid values, one line each.
std::vector<std::string> competition_errors(const Competition& competition);

}  // namespace cls::league
