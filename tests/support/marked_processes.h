// Finds processes by a mark in their environment: evidence that is independent of parents.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace cls::tests {

/// The variable with the mark; descendants of a marked process inherit it.
inline constexpr const char* kMarkVariable = "CLS_TEST_MARK";

/// The line of a shell script that passes the mark on: external teams inherit no variables.
inline std::string export_mark(const std::string& mark) {
  return std::string("export ") + kMarkVariable + "=" + mark + "\n";
}

/// A unique mark.
std::string new_mark();

/// Running processes with CLS_TEST_MARK=`mark` in their environment; zombies are not counted.
std::vector<int> marked_processes(const std::string& mark);

/// Waits until no marked process is left; false after `limit`.
bool all_marked_gone(const std::string& mark,
                     std::chrono::milliseconds limit = std::chrono::seconds(2));

}  // namespace cls::tests
