// Searches everything that `cls help` and `cls explain` can print.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

/// Something that has all the words of a search.
struct HelpMatch {
  std::string kind;  ///< "command", "option", "page", or the kind of an entry of `cls explain`
  std::string name;  ///< "cls tournament run", "--seed of cls match", "matches", "Self.stamina"
  std::string text;  ///< its first line, or of a page the first line with all the words
  std::string read;  ///< the command that prints it: "cls help matches"
};

/// Commands first, then pages, then names of the interface. Case does not count.
std::vector<HelpMatch> search_help(const Command& root, const std::vector<std::string>& words);

}  // namespace cls::cli
