// Errors found while a log is parsed, and their places.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cls::gamelog {

/// One place at which a log is corrupt or truncated.
struct ParseError {
  std::uint64_t line = 0;  ///< from 1; 0 in binary logs
  std::uint64_t byte = 0;  ///< from 0, in the uncompressed log
  int cycle = 0;           ///< of the last frame before the error
  std::string message;
};

/// "game.rcg: line 12, byte 3456, cycle 7: expected a number".
std::string format_error(std::string_view path, const ParseError& error);

/// The first errors of a log, and the number of all.
struct ParseErrors {
  static constexpr std::size_t kMaxStored = 20;

  std::vector<ParseError> first;
  std::uint64_t count = 0;

  void add(ParseError error);
  /// Adds `error`, or appends its message to the last error if that has the same place.
  void add_cause(ParseError error);
  bool empty() const { return count == 0; }
};

}  // namespace cls::gamelog
