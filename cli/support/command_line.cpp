// Reads /proc/self.
#include "cli/support/command_line.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <system_error>

#include "orchestration/process/command_plan.h"

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
    words.push_back(orchestration::process::shell_quoted(argument));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

base::Result<std::string> own_program() {
  std::error_code code;
  const auto file = std::filesystem::read_symlink("/proc/self/exe", code);
  if (code) return base::Error{fmt::format("/proc/self/exe: cannot read: {}", code.message())};
  return file.string();
}

}  // namespace cls::cli
