// Formats and collects parse errors.
#include "gamelog/record/parse_errors.h"

#include <utility>

namespace cls::gamelog {

std::string format_error(std::string_view path, const ParseError& error) {
  std::string text(path);
  text += ": ";
  if (error.line > 0) text += "line " + std::to_string(error.line) + ", ";
  text += "byte " + std::to_string(error.byte) + ", cycle " + std::to_string(error.cycle) + ": ";
  return text + error.message;
}

void ParseErrors::add(ParseError error) {
  if (first.size() < kMaxStored) first.push_back(std::move(error));
  ++count;
}

void ParseErrors::add_cause(ParseError error) {
  const bool same_place =
      count > 0 && count == first.size() &&
      (first.back().byte == error.byte || (error.line > 0 && first.back().line == error.line));

  if (same_place) {
    first.back().message += ": " + error.message;
  } else {
    add(std::move(error));
  }
}

}  // namespace cls::gamelog
