// Which logs a user means: files, folders, patterns; and which two belong to one match.
#pragma once

#include <string>
#include <vector>

namespace cls::gamelog {

/// The logs of one match. One of both may be empty; "-" is standard input.
struct MatchLogs {
  std::string game;  ///< rcg
  std::string text;  ///< rcl
};

struct FoundLogs {
  std::vector<MatchLogs> matches;    ///< in the order of the arguments, folders by name
  std::vector<std::string> missing;  ///< arguments that stand for nothing
};

/// Files are game logs unless they end in .rcl or .rcl.gz. A folder stands for all logs in and
/// below it (.rcg, .rcg.gz, .rcl, .rcl.gz), a pattern with * ? [ that is no file for what it
/// matches. Logs that differ in the ending alone belong to one match; the text log beside a game
/// log is found without being named.
FoundLogs find_logs(const std::vector<std::string>& arguments);

}  // namespace cls::gamelog
