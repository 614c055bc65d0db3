// Manual pages of all commands, in the language of man(7).
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cls::cli {

struct ManPage {
  std::string file;  ///< "cls-tournament-run.1"
  std::string text;
};

/// The page of `app`, which has all commands, and one per command below it.
std::vector<ManPage> man_pages(const CLI::App& app);

}  // namespace cls::cli
