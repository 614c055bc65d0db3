// Writing and reading the list.
#include "proxy/perception/player_types_message.h"

#include <charconv>

namespace cls::proxy {
namespace {

constexpr std::string_view kHead = "(player_types";

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool take(char wanted) {
    skip_blanks();
    if (text_.empty() || text_.front() != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool take(int& number) {
    skip_blanks();
    const auto [end, code] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (code != std::errc{}) return false;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return true;
  }

 private:
  void skip_blanks() {
    while (!text_.empty() && text_.front() == ' ') text_.remove_prefix(1);
  }

  std::string_view text_;
};

}  // namespace

std::string player_types_text(const TypeIds& types) {
  std::string text(kHead);
  for (std::size_t i = 0; i < types.size(); ++i) {
    text += " (" + std::to_string(i + 1) + " " + std::to_string(types[i]) + ")";
  }
  return text + ")";
}

std::optional<TypeIds> read_player_types(std::string_view text) {
  const std::size_t start = text.find(kHead);
  if (start == std::string_view::npos) return std::nullopt;
  Reader in(text.substr(start + kHead.size()));
  TypeIds types;
  types.fill(-1);
  while (in.take('(')) {
    int unum = 0;
    int type = 0;
    if (!in.take(unum) || !in.take(type) || !in.take(')')) return std::nullopt;
    if (unum < 1 || unum > soccer::kPlayersPerTeam || type < -1) return std::nullopt;
    types[static_cast<std::size_t>(unum - 1)] = type;
  }
  if (!in.take(')')) return std::nullopt;
  return types;
}

}  // namespace cls::proxy
