// Exceptions and repetitions in the output of a program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::process {

/// The first exception that a program printed, as its last line says it: "ValueError: no ball" of a
/// Python traceback, the innermost cause of a Java, JavaScript or C# stack trace, the line of a Go
/// or Rust panic, what() of C++. Empty: none. Safe to print.
std::string printed_exception(std::string_view log);

/// The line that an OutputLog counted most often.
struct RepeatedLine {
  std::string text;  ///< safe to print
  std::size_t times = 0;
};
RepeatedLine most_repeated_line(std::string_view log);

}  // namespace cls::process
