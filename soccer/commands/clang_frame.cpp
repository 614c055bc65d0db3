// Kinds, parentheses and freeform text of coach language messages.
#include "soccer/commands/clang_frame.h"

#include "base/text/enum_names.h"
#include "soccer/commands/player_command_lexer.h"
#include "soccer/protocol/loose_scanner.h"

namespace cls::soccer {
namespace {

constexpr auto kKinds =
    base::enum_names<ClangKind>("freeform", "info", "advice", "define", "meta", "rule", "delete");

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || c == '_'; }

// Length of the parenthesized expression at the start of `text`, ignoring parentheses in quotes; 0
// if it is not closed.
std::size_t expression_length(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (text[i] == '(') ++depth;
    if (text[i] == ')' && --depth == 0) return i + 1;
  }
  return 0;
}

// `inside` is the text between "(freeform" and its ")".
bool is_freeform(std::string_view inside) {
  LooseScanner in(inside);
  if (!in.token("\"")) return false;
  const std::size_t length = in.rest().find('"');
  if (length == std::string_view::npos || !is_sayable(in.rest().substr(0, length))) return false;
  in.skip_to('"');
  return in.token("\"") && (in.skip_space(), in.at_end());
}

}  // namespace

std::optional<CoachSay> parse_clang_say(std::string_view text) {
  LooseScanner in(text);
  in.skip_space();
  const std::string_view message = in.rest().substr(0, expression_length(in.rest()));
  if (message.empty() || message.front() != '(') return std::nullopt;
  LooseScanner inner(message.substr(1, message.size() - 2));
  const std::optional<ClangKind> kind = kKinds.parse(inner.run(is_letter, message.size()));
  if (!kind || (*kind == ClangKind::kFreeform && !is_freeform(inner.rest()))) return std::nullopt;

  if (!in.token(message) || !in.token(")")) return std::nullopt;
  in.skip_space();
  if (!in.at_end()) return std::nullopt;
  CoachSay said{*kind, std::string(message)};
  if (*kind == ClangKind::kFreeform) {  // delivered without the spaces around the text
    said.text = "(freeform \"" + std::string(said.freeform()) + "\")";
  }
  return said;
}

}  // namespace cls::soccer
