// What is to be started, as plain data: the same for --dry-run and for the start itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::orchestration::process {

/// One difference to our own environment; without a value the variable is taken out.
struct EnvironmentChange {
  std::string name;
  std::optional<std::string> value;

  bool operator==(const EnvironmentChange&) const = default;
};

/// One process to start.
struct CommandPlan {
  std::string name;               ///< for people: "right coach", "rcssserver"
  std::vector<std::string> argv;  ///< the program, then its arguments
  std::filesystem::path folder;   ///< working directory; empty: ours
  std::vector<EnvironmentChange> environment;
  std::filesystem::path log;  ///< its stdout and stderr go there; empty: kept nowhere
  std::vector<int> cpus;      ///< processors it may run on; empty: all

  bool operator==(const CommandPlan&) const = default;
};

/// `text` run by /bin/sh -c.
CommandPlan shell_command(std::string name, const std::string& text);

/// `word` as one word of POSIX sh: bare where that is safe, else in single quotes.
std::string shell_quoted(std::string_view word);

/// The plan as one line of sh that does the same when typed, with `cd` and `env` where needed.
std::string to_shell(const CommandPlan& plan);

/// The file that `program` names: itself when it has a slash, else the first on PATH. The error
/// names the program and says what is wrong (missing, a folder, not executable).
base::Result<std::filesystem::path> find_program(const std::string& program);

}  // namespace cls::orchestration::process
