// Lines of a debug log, shortened.
#include "match/hooks/drawing_text.h"

#include <string_view>

#include "base/text/decimal_text.h"
#include "base/text/number_text.h"
#include "proxy/actions/debug_log.h"
#include "viewer/decisions/decision_texts.h"

namespace cls::match {
namespace {

constexpr int kDecimals = 2;

// How many numbers follow the letter of a shape.
std::size_t numbers_of(char letter) {
  switch (letter) {
    case 'p':
    case 'm':
      return 2;
    case 'c':
    case 'C':
      return 3;
    case 'l':
    case 'r':
    case 'R':
      return 4;
    case 'a':
      return 5;
    case 't':
    case 'T':
    case 's':
    case 'S':
      return 6;
    default:
      return 0;
  }
}

// The next word of a line, with the space before it.
std::string_view take_word(std::string_view& line) {
  const std::size_t end = line.find(' ', 1);
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(word.size());
  return word;
}

// "0,0 8 c 1.5000 2.0000 3.0000 red" is "8 c 1.5 2 3 red".
std::string shortened(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  take_word(line);
  std::string text(take_word(line).substr(1));
  const std::string_view letter = take_word(line);
  text += letter;
  for (std::size_t i = 0; i < numbers_of(letter.back()); ++i) {
    double value = 0.0;
    const std::string_view word = take_word(line).substr(1);
    if (base::parse_number_prefix(word, value) != word.size()) return {};  // not finite
    text += ' ' + base::decimal_text(value, kDecimals);
  }
  return text.append(line) + '\n';
}

std::string line_of(const protos::PlayerAction& action) {
  std::string line;
  if (action.has_debug_client()) {
    proxy::append_debug_text(action.debug_client().message(), {}, line);
  } else if (action.has_log()) {
    proxy::append_debug_action(action.log(), {}, line);
  }
  return line.empty() ? line : shortened(line);
}

}  // namespace

bool is_drawing(const protos::PlayerAction& action) {
  return action.has_log() || action.has_debug_client();
}

std::string drawings_text(const protos::PlayerActions& reply) {
  std::string text;
  for (const protos::PlayerAction& action : reply.actions()) {
    const std::string line = line_of(action);
    if (text.size() + line.size() <= viewer::kMaxDecisionText) text += line;
  }
  return text;
}

}  // namespace cls::match
