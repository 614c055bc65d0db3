// Quoting for the shell and the search for programs.
#include "process/command_plan.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "base/text/replace_all.h"
#include "base/text/split.h"
#include "process/interpreter.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-+./:,@%^=").find(c) != std::string_view::npos;
}

bool is_program(const fs::path& path) {
  std::error_code code;
  return fs::is_regular_file(path, code) && ::access(path.c_str(), X_OK) == 0;
}

}  // namespace

CommandPlan shell_command(std::string name, const std::string& text) {
  CommandPlan plan;
  plan.name = std::move(name);
  plan.argv = {"/bin/sh", "-c", text};
  return plan;
}

std::string shell_quoted(std::string_view word) {
  std::string text(word);
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;

  base::replace_all(text, "'", "'\\''");
  return "'" + text + "'";
}

std::string to_shell(const CommandPlan& plan) {
  std::string line;
  const bool limited = plan.limits != ResourceLimits();
  if (limited) line += "(";  // so that the limits end with the command

  if (plan.limits.memory != 0) line += fmt::format("ulimit -d {}; ", plan.limits.memory / 1024);
  if (plan.limits.cpu_seconds != 0) line += fmt::format("ulimit -t {}; ", plan.limits.cpu_seconds);
  if (!plan.folder.empty()) line += fmt::format("cd {} && ", shell_quoted(plan.folder.string()));

  if (plan.empty_environment || !plan.environment.empty()) {
    line += plan.empty_environment ? "env -i " : "env ";
    for (const EnvironmentChange& change : plan.environment) {
      if (!change.value) line += fmt::format("-u {} ", shell_quoted(change.name));
    }
    for (const EnvironmentChange& change : plan.environment) {
      if (change.value) line += fmt::format("{}={} ", change.name, shell_quoted(*change.value));
    }
  }

  if (!plan.cpus.empty()) line += fmt::format("taskset -c {} ", fmt::join(plan.cpus, ","));

  std::vector<std::string> words;
  for (const std::string& word : plan.argv) words.push_back(shell_quoted(word));
  return fmt::format("{}{}{}", line, fmt::join(words, " "), limited ? ")" : "");
}

Result<fs::path> find_program(const std::string& program) {
  if (program.empty()) return Error{"no program to start"};
  if (program.find('/') != std::string::npos) {
    std::error_code code;
    const fs::path path = fs::absolute(program, code);
    if (!fs::exists(path, code)) return Error{fmt::format("{}: no such file", program)};
    if (fs::is_directory(path, code)) {
      return Error{fmt::format("{} is a folder, not a program", program)};
    }
    if (!is_program(path)) return Error{fmt::format("{} is not executable", program)};
    if (const std::string missing = missing_interpreter(path); !missing.empty()) {
      return Error{fmt::format("{} cannot be started: {}", program, missing)};
    }
    return path;
  }

  const char* folders = std::getenv("PATH");
  if (folders == nullptr) folders = "/usr/local/bin:/usr/bin:/bin";
  for (const std::string_view folder : base::split(folders, ':')) {
    std::error_code code;
    const fs::path path = fs::absolute(fs::path(folder.empty() ? "." : folder) / program, code);
    if (is_program(path)) return path;
  }
  return Error{fmt::format("{}: no such program on PATH", program)};
}

}  // namespace cls::process
