// Error lines on stderr, and what follows from an error: the end of a command.
#pragma once

#include <fmt/core.h>

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "cli/terminal/exit_code.h"

namespace cls::cli {

/// Prints "cls: MESSAGE" to stderr and returns `exit_code`.
int print_error(int exit_code, std::string_view message);

template <class First, class... Rest>
int print_error(int exit_code, fmt::format_string<First, Rest...> format, First&& first,
                Rest&&... rest) {
  return print_error(exit_code, std::string_view(fmt::format(format, std::forward<First>(first),
                                                             std::forward<Rest>(rest)...)));
}

/// One line per message.
int print_errors(int exit_code, const std::vector<std::string>& messages);

/// The line of an exception that nothing has caught, as an internal error if none of its known
/// causes; returns the exit code of `cls`.
int print_exception(const std::exception& error);

}  // namespace cls::cli

/// Prints the error of a result and returns the exit code from the calling function, if it has one:
///   TRY_OR(kCannotCreate, base::create_folders(folder));
#define TRY_OR(exit_code, ...)                                                              \
  if (auto CLS_JOIN(result_at_, __LINE__) = (__VA_ARGS__); !CLS_JOIN(result_at_, __LINE__)) \
  return print_error(exit_code, CLS_JOIN(result_at_, __LINE__).error().message)

/// Prints the error of a result and returns the exit code, if it has one; else initializes a
/// variable with the value:
///   TRY_INIT_OR(kBadData, const auto state, read_tournament(folder));
#define TRY_INIT_OR(exit_code, declaration, ...)                                   \
  auto CLS_JOIN(result_at_, __LINE__) = (__VA_ARGS__);                             \
  if (!CLS_JOIN(result_at_, __LINE__)) {                                           \
    return print_error(exit_code, CLS_JOIN(result_at_, __LINE__).error().message); \
  }                                                                                \
  declaration = *std::move(CLS_JOIN(result_at_, __LINE__))

/// Returns the exit code of a step from the calling function, unless it is kOk:
///   TRY_STEP(read_match(log, match));
#define TRY_STEP(...) \
  if (const int code_of_step = (__VA_ARGS__); code_of_step != kOk) return code_of_step
