// Numbers as the protocol and the logs print them, and reading them back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::soccer {

/// Appends `value` as a C++ stream with default settings prints it (printf's %g): six significant
/// digits, no trailing zeros, an exponent for very small and very large values, "-0" for negative
/// zero. This is the form of every number the real server sends or logs.
void append_g(double value, std::string& out);

/// Appends `value` as a plain decimal integer.
void append_int(std::int64_t value, std::string& out);

/// Appends the shortest text that reads back as exactly `value`. `value` must be finite.
void append_shortest(double value, std::string& out);

/// Reads a whole text as a number: optional sign, digits with an optional point, optional
/// exponent. No blanks, no hexadecimal, no inf or nan. Correctly rounded; beyond the range of a
/// double the result is infinite or zero with the right sign.
std::optional<double> number_from_text(std::string_view text);

/// Reads a whole text as a decimal integer that fits an int; a plus sign is accepted.
std::optional<int> int_from_text(std::string_view text);

}  // namespace cls::soccer
