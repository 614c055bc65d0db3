// Numbers as the protocol and the logs print them, and reading them back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::base {

/// Appends `value` as a C++ stream with default settings prints it (printf's %g): six significant
/// digits, no trailing zeros, an exponent for very small and very large values, "-0" for negative
/// zero. This is the form of every number the real server sends or logs.
void append_g(double value, std::string& out);

/// Appends `value` as a plain decimal integer.
void append_int(std::int64_t value, std::string& out);

/// The same at `to`, where kNumberRoom characters have room; they return the end of what they
/// wrote.
constexpr std::size_t kNumberRoom = 32;
char* write_g(double value, char* to);
char* write_int(std::int64_t value, char* to);

/// Appends the shortest text that reads back as exactly `value`. `value` must be finite.
void append_shortest(double value, std::string& out);

/// Reads the longest number at the start of `text` and returns its length, 0 if there is none.
/// A number is an optional sign, digits with an optional point that digits follow (".5" but not
/// "5."), and an optional exponent; no blanks, no hexadecimal, no inf or nan. The value is
/// correctly rounded and always finite: one beyond the range of a double becomes the largest.
std::size_t read_number(std::string_view text, double& value);

/// The same for a decimal integer; a value beyond the range of an int becomes the nearest int.
std::size_t read_int(std::string_view text, int& value);

/// A whole text as a number; nothing if it is not one.
std::optional<double> number_from_text(std::string_view text);

/// A whole text as an integer; nothing if it is not one.
std::optional<int> int_from_text(std::string_view text);

}  // namespace cls::base
