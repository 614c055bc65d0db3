// Results of matches that were played elsewhere, as a text file.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// "3:0": goals of the left and the right team, none of them negative.
std::optional<std::pair<int, int>> parse_goals(std::string_view text);

/// Outcomes by stage and teams. A line "[first round, group C]" names the stage of the lines below
/// it, "HELIOS 2:2 (4:3) CYRUS" is a result, with the goals of a shoot-out in parentheses. '#'
/// starts a comment.
class ResultsFile {
 public:
  /// Parses the text of a file; `file` is its name in messages. The error names the line.
  static base::Result<ResultsFile> parse(std::string_view text, const std::string& file,
                                         const TournamentConfig& config);
  static base::Result<ResultsFile> read(const std::filesystem::path& file,
                                        const TournamentConfig& config);

  /// The outcome of a fixture, whichever team is on the left. The error names the fixture.
  base::Result<Outcome> find(const TournamentConfig& config, const Fixture& fixture) const;

 private:
  struct Entry {
    int left = 0;  // a team
    Outcome outcome;
  };
  using Key = std::pair<std::string, std::pair<int, int>>;  // stage, teams by index

  base::Result<void> add(std::string_view line, const std::string& stage,
                         const TournamentConfig& config);

  std::string file_;
  std::map<Key, Entry> entries_;
};

}  // namespace cls::tournament
