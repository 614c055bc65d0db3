// Longest-match lexer of player commands.
#include "soccer/commands/player_command_lexer.h"

#include <algorithm>
#include <array>

#include "base/index.h"
#include "base/text/number_text.h"
#include "soccer/protocol/wrapped_int.h"

namespace cls::soccer {
namespace {

using Kind = CommandToken::Kind;

bool is_alphanumeric(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

bool is_name_character(char c) { return is_alphanumeric(c) || c == '-' || c == '_'; }

template <typename Accepted>
std::size_t run_length(std::string_view text, Accepted accepted) {
  return base::index(std::ranges::find_if_not(text, accepted) - text.begin());
}

// Length of `"..."` with at least one say character inside, otherwise 0.
std::size_t quoted_length(std::string_view text) {
  if (!text.starts_with('"')) return 0;
  const std::size_t inside = run_length(text.substr(1), is_say_character);
  return inside > 0 && text.substr(1 + inside).starts_with('"') ? inside + 2 : 0;
}

}  // namespace

bool is_say_character(char c) {
  return is_alphanumeric(c) || std::string_view(" ().+-*/?<>_").find(c) != std::string_view::npos;
}

bool is_command_keyword(std::string_view token) {
  constexpr std::array kKeywords = std::to_array<std::string_view>({"dash",
                                                                    "turn",
                                                                    "turn_neck",
                                                                    "change_focus",
                                                                    "kick",
                                                                    "long_kick",
                                                                    "catch",
                                                                    "say",
                                                                    "sense_body",
                                                                    "score",
                                                                    "move",
                                                                    "change_view",
                                                                    "bye",
                                                                    "done",
                                                                    "compression",
                                                                    "pointto",
                                                                    "attentionto",
                                                                    "tackle",
                                                                    "clang",
                                                                    "ear",
                                                                    "synch_see",
                                                                    "narrow",
                                                                    "gaussian_see",
                                                                    "normal",
                                                                    "wide",
                                                                    "low",
                                                                    "high",
                                                                    "on",
                                                                    "off",
                                                                    "our",
                                                                    "opp",
                                                                    "left",
                                                                    "right",
                                                                    "l",
                                                                    "r",
                                                                    "partial",
                                                                    "complete",
                                                                    "p",
                                                                    "c",
                                                                    "ver",
                                                                    "true",
                                                                    "false"});

  return std::ranges::find(kKeywords, token) != kKeywords.end();
}

CommandToken CommandLexer::take(Kind kind, std::size_t length) {
  CommandToken token;
  token.kind = kind;
  token.position = at_;
  token.text = text_.substr(at_, length);
  at_ += length;
  return token;
}

bool CommandLexer::take_unquoted_say(CommandToken& token) {
  constexpr std::string_view kStart = "(say ";
  const std::string_view rest = text_.substr(at_);
  if (!rest.starts_with(kStart)) return false;

  const std::string_view run =
      rest.substr(kStart.size(), run_length(rest.substr(kStart.size()), is_say_character));

  const std::size_t closing = run.rfind(')');
  if (closing == std::string_view::npos || closing == 0) return false;

  token = take(Kind::kUnquotedSay, kStart.size() + closing + 1);
  token.text = run.substr(0, closing);
  return true;
}

CommandToken CommandLexer::next() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) {
    ++at_;
  }

  if (at_ == text_.size()) return take(Kind::kEnd, 0);
  CommandToken token;
  if (take_unquoted_say(token)) return token;

  const std::string_view rest = text_.substr(at_);
  if (rest[0] == '(') return take(Kind::kOpen, 1);
  if (rest[0] == ')') return take(Kind::kClose, 1);

  double number = 0.0;
  int integer = 0;
  const std::size_t number_length = base::parse_number_prefix(rest, number);
  const std::size_t name_length = run_length(rest, is_name_character);

  if (number_length > 0 && number_length >= name_length) {
    const bool whole = parse_wrapped_int(rest, integer) == number_length;
    token = take(whole ? Kind::kInteger : Kind::kReal, number_length);
    token.number = whole ? integer : number;
    token.integer = integer;
    return token;
  }

  if (name_length > 0) return take(Kind::kName, name_length);
  if (const std::size_t length = quoted_length(rest); length > 0)
    return take(Kind::kQuoted, length);
  return take(Kind::kInvalid, 1);
}

}  // namespace cls::soccer
