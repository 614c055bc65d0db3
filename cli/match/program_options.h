// Options for the programs that a match starts for its sides: limits and the sandbox.
#pragma once

#include <string>
#include <vector>

#include "orchestration/match/options/match_options.h"

namespace CLI {
class App;
}

namespace cls::cli {

/// As written; read_program_options() sets the match's options.
struct ProgramOptions {
  std::string max_memory;
  std::optional<int> max_cpu;
};

/// --max-memory and --max-cpu.
void add_program_options(CLI::App& command, ProgramOptions& programs);

/// --sandbox and --no-sandbox.
void add_sandbox_option(CLI::App& command, bool& sandbox);

/// Adds a line to `errors` for each value that cannot be used. Options that were not given change
/// nothing.
void read_program_options(const ProgramOptions& programs,
                          orchestration::match::MatchOptions& options,
                          std::vector<std::string>& errors);

}  // namespace cls::cli
