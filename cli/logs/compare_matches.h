// `cls watch A B`: two matches side by side.
#pragma once

#include <string>

namespace cls::cli {

struct CompareArguments {
  std::string first;
  std::string second;
  std::string out;  ///< page to write; empty: compare.html beside the first log, and opened
  bool no_open = false;
  bool json = false;
};

/// Prints the differences and writes the page. Returns an exit code.
int compare_matches(const CompareArguments& arguments);

}  // namespace cls::cli
