// A stage of a tournament in stages as plain data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/text/enum_names.h"

namespace cls::league {

/// How the teams of a stage meet. knockout.cpp plays all but the groups.
enum class StageFormat {
  kGroups,      ///< every team of a group against every other of it
  kKnockout,    ///< single elimination
  kStepladder,  ///< the last rank plays the one above it, the winner the next, up to the first
};

inline constexpr auto kStageFormats =
    base::enum_names<StageFormat>("groups", "knockout", "stepladder");

constexpr std::string_view name(StageFormat format) { return kStageFormats.name(format); }

/// One stage. Its entrants follow from the results of the stages before it.
struct Stage {
  std::string name;  ///< "first round"; precedes the names of its matches
  StageFormat format = StageFormat::kGroups;
  /// Earlier stages whose matches rank the entrants in one table, by points per match. Empty: the
  /// entrants have the ranks of the stage before, and those of the seeding in the first stage.
  std::vector<std::string> ranked_by;
  int groups = 1;                               ///< filled in serpentine order of the ranks
  std::vector<std::vector<std::string>> drawn;  ///< the groups by name instead; first stage only
  std::vector<int> divisions;      ///< sizes of groups that take the ranks from the first one on
  int legs = 1;                    ///< matches of two teams, each on its own seed
  int teams = 0;                   ///< the best of the entrants that take part; 0: all
  std::vector<std::string> join;   ///< teams that enter with this stage, below all others
  std::vector<std::string> carry;  ///< earlier stages whose matches count in the tables too
  bool third_place = true;         ///< knockout: the losing semi-finalists meet

  bool operator==(const Stage&) const = default;
};

/// All errors of the stages of a competition of these teams, one line each.
std::vector<std::string> stage_errors(const std::vector<Stage>& stages,
                                      const std::vector<std::string>& teams);

}  // namespace cls::league
