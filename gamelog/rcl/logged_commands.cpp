// Splits logged datagrams into commands.
#include "gamelog/rcl/logged_commands.h"

#include <algorithm>
#include <array>

#include "soccer/commands/player_command_lexer.h"

namespace cls::gamelog {
namespace {

constexpr std::array<std::string_view, kCommandKindCount> kNames = {
    "dash",  "turn",        "turn_neck",    "kick",         "long_kick", "tackle",      "catch",
    "move",  "change_view", "change_focus", "say",          "pointto",   "attentionto", "ear",
    "clang", "compression", "synch_see",    "gaussian_see", "score",     "sense_body",  "done",
    "bye",   "init",        "reconnect",    "other"};

constexpr std::string_view kUnquotedSay = "(say ";

// Command kinds by first letter: `order` lists those whose names begin with 'a' + i from index
// `first[i]` to `first[i + 1]`.
struct LetterIndex {
  std::array<CommandKind, kCommandKindCount - 1> order = {};
  std::array<std::uint8_t, 27> first = {};
};

constexpr LetterIndex index_by_letter() {
  LetterIndex index;
  std::size_t count = 0;

  for (std::size_t letter = 0; letter < 26; ++letter) {
    index.first[letter] = static_cast<std::uint8_t>(count);
    for (std::size_t i = 0; i + 1 < kNames.size(); ++i) {
      if (kNames[i][0] == static_cast<char>('a' + letter)) {
        index.order[count++] = static_cast<CommandKind>(i);
      }
    }
  }

  index.first[26] = static_cast<std::uint8_t>(count);
  return index;
}

constexpr LetterIndex kByLetter = index_by_letter();

CommandKind kind_of(std::string_view name) {
  if (name.empty() || name[0] < 'a' || name[0] > 'z') return CommandKind::kOther;

  const auto letter = static_cast<std::size_t>(name[0] - 'a');
  for (std::size_t i = kByLetter.first[letter]; i < kByLetter.first[letter + 1]; ++i) {
    if (kNames[static_cast<std::size_t>(kByLetter.order[i])] == name) return kByLetter.order[i];
  }

  return CommandKind::kOther;
}

// Length of the expression at the start of `text` up to its closing bracket; 0 if it is not closed.
std::size_t expression_length(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') {
      ++depth;
    } else if (text[i] == ')') {
      if (--depth == 0) return i + 1;
    } else if (text[i] == '"') {
      i = text.find('"', i + 1);
      if (i == std::string_view::npos) return 0;
    }
  }

  return 0;
}

// rcssserver's lexer consumes all say characters, up to the last closing bracket among them.
std::size_t unquoted_say_length(std::string_view text) {
  if (!text.starts_with(kUnquotedSay)) return 0;

  const auto end =
      std::find_if_not(text.begin() + kUnquotedSay.size(), text.end(), soccer::is_say_character);
  const std::size_t closing =
      text.substr(0, static_cast<std::size_t>(end - text.begin())).rfind(')');
  return closing == std::string_view::npos || closing <= kUnquotedSay.size() ? 0 : closing + 1;
}

}  // namespace

std::string_view name(CommandKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

bool is_body_command(CommandKind kind) {
  using enum CommandKind;
  return kind == kDash || kind == kTurn || kind == kKick || kind == kLongKick || kind == kTackle ||
         kind == kCatch || kind == kMove;
}

bool CommandCursor::next(LoggedCommand& command) {
  const std::size_t open = rest_.starts_with('(') ? 0 : rest_.find('(');
  if (open == std::string_view::npos) return false;
  rest_.remove_prefix(open);

  std::size_t length = unquoted_say_length(rest_);
  if (length == 0) length = expression_length(rest_);
  if (length == 0) return false;

  const std::string_view inside = rest_.substr(1, length - 2);
  rest_.remove_prefix(length);

  // Not find_first_of(), which calls memchr() for each character.
  const auto ends_name = [](char c) { return c == ' ' || c == '('; };
  const auto name_end =
      static_cast<std::size_t>(std::ranges::find_if(inside, ends_name) - inside.begin());
  command.kind = kind_of(inside.substr(0, name_end));
  command.arguments = inside.substr(std::min(name_end + 1, inside.size()));
  return true;
}

}  // namespace cls::gamelog
