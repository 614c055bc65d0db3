// Manual pages of all commands, in the language of man(7).
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

struct ManPage {
  std::string file;  ///< "cls-tournament-run.1"
  std::string text;
};

/// The page of `root`, which has all commands, and one per command below it.
std::vector<ManPage> man_pages(const Command& root);

}  // namespace cls::cli
