// Recordings of terminals in the format of asciinema, version 2.
#pragma once

#include <string>
#include <string_view>

namespace cls::viewer {

/// The first line.
std::string cast_header(int columns, int rows, const std::string& title);

/// A line: `output` appeared after so many seconds.
std::string cast_line(double seconds, std::string_view output);

}  // namespace cls::viewer
