// Declares and reads the options.
#include "cli/match/program_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/text/byte_size.h"

namespace cls::cli {

void add_sandbox_option(CLI::App& command, bool& sandbox) {
  command.add_flag("--sandbox,!--no-sandbox", sandbox,
                   "let team: sides read the system and change their own folder only\n"
                   "(default: on; docs/security.md)");
}

void add_program_options(CLI::App& command, ProgramOptions& programs) {
  command.add_option("--max-memory", programs.max_memory,
                     "memory of each process of run: and team: sides, such as 512M or 2G:\n"
                     "what it allocates for itself, without files and shared memory\n"
                     "(default: no limit)");
  command
      .add_option("--max-cpu", programs.max_cpu,
                  "seconds of CPU time of each process of run: and team: sides; its\n"
                  "child processes have their own (default: no limit)")
      ->check(CLI::PositiveNumber);
}

void read_program_options(const ProgramOptions& programs,
                          orchestration::match::MatchOptions& options,
                          std::vector<std::string>& errors) {
  if (programs.max_cpu) options.limits.cpu_seconds = *programs.max_cpu;
  if (programs.max_memory.empty()) return;
  if (const auto size = base::parse_byte_size(programs.max_memory)) {
    options.limits.memory = *size;
  } else {
    errors.push_back(
        fmt::format("--max-memory '{}': must be a size such as 512M or 2G", programs.max_memory));
  }
}

}  // namespace cls::cli
