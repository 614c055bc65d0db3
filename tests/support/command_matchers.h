// Matchers of what a program has returned and printed.
#pragma once

#include <gmock/gmock.h>

#include <ostream>

#include "tests/support/command.h"

namespace cls::tests {

inline void PrintTo(const CommandResult& result, std::ostream* out) {
  *out << "exit code " << result.exit_code << ", stdout:\n"
       << result.out << "\nstderr:\n"
       << result.err;
}

/// A result with this exit code.
inline auto Exits(int code) {
  return testing::Field("exit_code", &CommandResult::exit_code, testing::Eq(code));
}

/// A result with this exit code whose stderr matches; a text is all of it.
template <typename Errors>
auto Exits(int code, Errors errors) {
  return testing::AllOf(Exits(code), testing::Field("err", &CommandResult::err, errors));
}

/// A result with this exit code whose stdout matches; a text is all of it.
template <typename Output>
auto Prints(int code, Output output) {
  return testing::AllOf(Exits(code), testing::Field("out", &CommandResult::out, output));
}

}  // namespace cls::tests
