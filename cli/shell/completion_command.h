// What completion scripts call.
#pragma once

#include <string>
#include <vector>
#include "cli/command/command.h"

namespace cls::cli {

/// `cls complete -- WORD...`: prints one candidate per line, "TEXT<tab>NOTE", and a line
/// ":files<tab>PREFIX" or ":folders<tab>PREFIX" where paths may stand. Returns kOk.
int print_completion(const Command& root, std::vector<std::string> words);

}  // namespace cls::cli
