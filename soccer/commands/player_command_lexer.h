// Cuts a player's datagram into tokens exactly as the real server's lexer does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cls::soccer {

struct CommandToken {
  enum class Kind : std::uint8_t {
    kOpen,
    kClose,
    kInteger,
    kReal,
    kWord,         ///< command names and other keywords too
    kQuoted,       ///< `text` with its quotes
    kUnquotedSay,  ///< a whole `(say ...)` without quotes; `text` is what is said
    kEnd,
    kInvalid,
  };

  Kind kind = Kind::kEnd;
  std::size_t position = 0;  ///< byte offset in the datagram
  std::string_view text;
  double number = 0.0;  ///< kInteger and kReal
  int integer = 0;      ///< kInteger
};

/// The longest match wins, so `(say a)(turn 5)` is one token and `10-5` a word. Blanks, tabs and
/// line feeds separate tokens and mean nothing else.
class CommandLexer {
 public:
  explicit CommandLexer(std::string_view text) : text_(text) {}

  CommandToken next();

 private:
  CommandToken take(CommandToken::Kind kind, std::size_t length);
  bool take_unquoted_say(CommandToken& token);

  std::string_view text_;
  std::size_t at_ = 0;
};

/// True for the keywords of the grammar, which cannot be team names.
bool is_command_keyword(std::string_view word);

/// True for characters that may be said.
bool is_say_character(char c);

}  // namespace cls::soccer
