// Formats and parses numbers as in the soccer protocol and the logs. Hand-written because
// observations and game logs are in the hot path; tests compare with printf and strtod.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::base {

/// Appends `value` as a C++ stream with default settings prints it (printf's %g): six significant
/// digits, no trailing zeros, an exponent for very small and very large values, "-0" for negative
/// zero. rcssserver sends and logs all numbers in this form.
void append_g(double value, std::string& out);

/// Appends `value` as a plain decimal integer.
void append_int(std::int64_t value, std::string& out);

/// Write to `to`, which has room for kMaxNumberLength characters, and return the end of the text.
constexpr std::size_t kMaxNumberLength = 32;
char* write_g(double value, char* to);
char* write_int(std::int64_t value, char* to);

/// Appends the shortest text that parses to exactly `value`, which must be finite.
void append_shortest(double value, std::string& out);

/// Parses the longest number at the start of `text` and returns its length, 0 if there is none.
/// A number is an optional sign, digits with an optional decimal point followed by digits (".5" but
/// not "5."), and an optional exponent; no white space, hexadecimal, inf or nan. The value is
/// correctly rounded and finite: values beyond the range of a double become the largest double.
std::size_t parse_number_prefix(std::string_view text, double& value);

/// Parses a decimal integer at the start of `text` and returns its length, 0 if there is none.
/// Values beyond the range of an int become the nearest int.
std::size_t parse_int_prefix(std::string_view text, int& value);

/// Parses all of `text`; nothing if it is not a number.
std::optional<double> parse_number(std::string_view text);

/// Parses all of `text`; nothing if it is not an integer.
std::optional<int> parse_int(std::string_view text);

}  // namespace cls::base
