// A process to start, as plain data: for --dry-run and for the start itself.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::process {

/// One change of the inherited environment; without a value the variable is removed.
struct EnvironmentChange {
  std::string name;
  std::optional<std::string> value;

  bool operator==(const EnvironmentChange&) const = default;
};

/// Limits of the kernel for each process of a program; descendants inherit the limits, but do not
/// share them. 0: no limit.
struct ResourceLimits {
  std::uint64_t memory = 0;  ///< bytes of private writable memory (RLIMIT_DATA)
  int cpu_seconds = 0;       ///< user and system time; SIGXCPU, then SIGKILL (RLIMIT_CPU)
  /// Of a program in namespaces: processes and threads that it may have at a time, with all its
  /// descendants (Linux 6.14; as another user than root those that all programs in them have).
  int processes = 0;

  bool operator==(const ResourceLimits&) const = default;
};

/// A symbolic link.
struct FileLink {
  std::filesystem::path path;
  std::filesystem::path target;

  bool operator==(const FileLink&) const = default;
};

/// The files that a program and its descendants can use; folders stand for all that is in them.
struct FileAccess {
  std::vector<std::filesystem::path> readable;  ///< to read and to execute
  std::vector<std::filesystem::path> writable;  ///< to change, too
  /// With namespaces: folders of its own in memory, and links, where there is nothing else.
  std::vector<std::filesystem::path> own = {};
  std::vector<FileLink> links = {};
  /// With namespaces: folders, in others, that are empty to it and cannot be changed.
  std::vector<std::filesystem::path> covered = {};

  bool operator==(const FileAccess&) const = default;
};

class Namespaces;

/// One process to start.
struct CommandPlan {
  std::string name;                ///< in messages: "right coach", "rcssserver"
  std::vector<std::string> argv;   ///< the program, then its arguments
  std::filesystem::path folder;    ///< working directory; empty: that of cls
  bool empty_environment = false;  ///< inherit no variables: `environment` has all
  std::vector<EnvironmentChange> environment;
  std::filesystem::path log;  ///< for stdout and stderr; empty: none
  std::vector<int> cpus;      ///< processor cores it may run on; empty: all
  ResourceLimits limits;
  std::optional<FileAccess> files;  ///< by Landlock, which must be there; none: as the user may
  bool confined = false;            ///< by confinement.h, which must be possible
  /// The namespaces in which it runs, with `files` and nothing else to see; null: those of cls.
  std::shared_ptr<const Namespaces> namespaces = nullptr;
  /// Descriptors of cls that it inherits, as kFirstPassedFd and the following.
  std::vector<int> passed = {};
  bool connections_trapped = false;  ///< the last of `passed` is that of a ConnectionTrap

  bool operator==(const CommandPlan&) const = default;
};

/// The number of the first inherited descriptor; no program has as many of its own at its start.
inline constexpr int kFirstPassedFd = 100;

/// `text` run by /bin/sh -c.
CommandPlan shell_command(std::string name, const std::string& text);

/// `word` quoted as one word of POSIX sh: unchanged where that is safe, otherwise in single quotes.
std::string shell_quoted(std::string_view word);

/// The plan as an equivalent line of sh, with `ulimit`, `cd` and `env` where needed; without
/// `files`, `confined` and `namespaces`.
std::string to_shell(const CommandPlan& plan);

/// The file of `program`: the path itself if it has a slash, otherwise the first match on PATH. The
/// error names the program and the problem (missing, a folder, not executable).
base::Result<std::filesystem::path> find_program(const std::string& program);

}  // namespace cls::process
