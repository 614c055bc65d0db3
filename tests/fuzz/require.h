// The end of a fuzzer whose input breaks a promise.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace cls::tests {

/// Aborts, so that the fuzzer keeps the input, and prints which promise is broken and what was
/// found.
inline void require(bool condition, const char* promise = "", const std::string& found = "") {
  if (condition) return;
  std::fprintf(stderr, "broken promise: %s: %s\n", promise, found.c_str());
  std::abort();
}

}  // namespace cls::tests
