// Where the commands of a team differ in two runs of one scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::cli {

struct CommandDifference {
  int cycle = 0;            ///< of the first difference
  std::string agent;        ///< "player 9", "the coach"
  std::string before;       ///< its commands; empty: none
  std::string now;          ///< its commands now; empty: none
  std::int64_t differ = 0;  ///< decisions that differ: those after the first may follow from it
  std::int64_t total = 0;   ///< decisions of the longer run
};

/// Compares the text logs (rcl) of two runs; nothing if team `name` sent the same commands.
std::optional<CommandDifference> compare_commands(std::string_view before, std::string_view now,
                                                  std::string_view name);

}  // namespace cls::cli
