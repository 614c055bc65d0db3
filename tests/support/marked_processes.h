// Finds processes by a mark in their environment: evidence that is independent of parents.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace cls::tests {

/// The variable that carries the mark; whatever descends from a marked process is marked too.
inline constexpr const char* kMarkVariable = "CLS_TEST_MARK";

/// A mark that no other test has.
std::string new_mark();

/// Living processes whose environment says CLS_TEST_MARK=`mark`. Zombies have none.
std::vector<int> marked_processes(const std::string& mark);

/// Waits until no marked process is left; true when that was within `limit`.
bool all_marked_gone(const std::string& mark, std::chrono::milliseconds limit);

}  // namespace cls::tests
