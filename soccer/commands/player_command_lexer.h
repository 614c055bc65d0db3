// Tokenizes player commands exactly like the lexer of rcssserver.
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
    kName,         ///< any name, including command names and keywords
    kQuoted,       ///< `text` with its quotes
    kUnquotedSay,  ///< a whole `(say ...)` without quotes; `text` is the message
    kEnd,
    kInvalid,
  };

  Kind kind = Kind::kEnd;
  std::size_t position = 0;  ///< byte offset in the datagram
  std::string_view text;
  double number = 0.0;  ///< kInteger and kReal
  int integer = 0;      ///< kInteger
};

/// The longest match wins, so `(say a)(turn 5)` is one token and `10-5` is a name. Spaces, tabs and
/// line feeds separate tokens.
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
bool is_command_keyword(std::string_view token);

/// True for characters that are allowed in say messages.
bool is_say_character(char c);

}  // namespace cls::soccer
