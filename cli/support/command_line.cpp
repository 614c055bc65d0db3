// Reads /proc/self.
#include "cli/support/command_line.h"

#include <fmt/format.h>

#include <fstream>

#include "process/command_plan.h"

namespace cls::cli {

std::vector<std::string> command_line() {
  std::vector<std::string> arguments;
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  for (std::string argument; std::getline(file, argument, '\0');) arguments.push_back(argument);
  return arguments;
}

std::string resume_command() {
  std::vector<std::string> words;
  for (const std::string& argument : command_line()) {
    if (argument == "--force") continue;
    words.push_back(process::shell_quoted(argument));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace cls::cli
