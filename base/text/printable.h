// Makes untrusted text safe to print: names, messages and output of programs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::base {

/// Length of the character at the start of `text`, which must not be empty, if it may be printed; 0
/// for control characters (line feed included), characters that change the direction of text or
/// have no width, and bytes that are not UTF-8.
std::size_t printable_length(std::string_view text);

/// One line: what may not be printed becomes '?', tabs become spaces.
std::string printable(std::string_view text);

/// Makes each line of a text safe to print.
std::string printable_lines(std::string_view text);

/// A JSON document with the characters that may not be printed as escapes: the same document.
std::string printable_json(std::string json);

}  // namespace cls::base
