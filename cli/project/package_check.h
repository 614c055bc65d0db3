// A package played as a competition plays it: each agent on a machine of its own, in real time.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"

namespace cls::cli {

struct PackageCheckOptions {
  std::filesystem::path package;
  std::filesystem::path root = "/";  ///< files of the machines, such as a bare Debian
  std::filesystem::path program;     ///< cls, for the server and the opponents
  std::filesystem::path folder;      ///< empty, for the files of the match
  int cycles = 6000;
  std::uint64_t memory = 1U << 30;  ///< bytes that an agent and its Playmaker may use
  int cpus = 1;                     ///< processors that they may use
};

/// One agent and its machine.
struct CheckedAgent {
  int unum = 0;  ///< 12: the coach
  bool finished = false;
  std::string problem;         ///< why it has not finished, or has missed too many cycles
  std::int64_t decisions = 0;  ///< of a player
  std::int64_t missed = 0;     ///< cycles without a decision, or without a usable reply
  std::int64_t late_commands = 0;
  double p99_ms = 0.0;                  ///< 99th percentile of the time to a reply
  std::optional<std::uint64_t> memory;  ///< peak in bytes; unknown without cgroups
};

struct PackageCheck {
  std::string skipped;    ///< why it could not run; empty: it has
  std::string c_library;  ///< version in `root`, "2.31"; empty: unknown
  bool own_files = true;  ///< root is this host's
  std::string limits;     ///< how they were set
  std::string problem;    ///< of the match as a whole; empty: none
  std::string busy;       ///< "this host is busy: load 54.9 on 2 processors"; empty: it was not
  std::vector<CheckedAgent> agents;

  bool passed() const;
};

/// The share of cycles that an agent may miss.
inline constexpr double kMaxMissedShare = 0.01;

/// Plays the match. The error names a folder that cannot be used. `stop`: the signal that
/// interrupts.
base::Result<PackageCheck> check_package(const PackageCheckOptions& options,
                                         const std::atomic<int>& stop);

/// The findings, as text and as the document `cls.package-check/1`.
std::string to_text(const PackageCheckOptions& options, const PackageCheck& check);
std::string to_json(const PackageCheckOptions& options, const PackageCheck& check);

}  // namespace cls::cli
