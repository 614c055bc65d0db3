// Formats and parses player_types messages.
#include "player/perception/player_types_message.h"

#include <charconv>

namespace cls::player {
namespace {

constexpr std::string_view kHead = "(player_types";

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool consume(char expected) {
    skip_spaces();
    if (text_.empty() || text_.front() != expected) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool parse(int& number) {
    skip_spaces();
    const auto [end, code] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (code != std::errc{}) return false;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return true;
  }

 private:
  void skip_spaces() {
    while (!text_.empty() && text_.front() == ' ') text_.remove_prefix(1);
  }

  std::string_view text_;
};

}  // namespace

std::string format_player_types(const TypeIds& types) {
  std::string text(kHead);
  for (std::size_t i = 0; i < types.size(); ++i) {
    text += " (" + std::to_string(i + 1) + " " + std::to_string(types[i]) + ")";
  }
  return text + ")";
}

std::optional<TypeIds> parse_player_types(std::string_view text) {
  const std::size_t start = text.find(kHead);
  if (start == std::string_view::npos) return std::nullopt;

  Reader in(text.substr(start + kHead.size()));
  TypeIds types;
  types.fill(-1);

  while (in.consume('(')) {
    int unum = 0;
    int type = 0;
    if (!in.parse(unum) || !in.parse(type) || !in.consume(')')) return std::nullopt;
    if (unum < 1 || unum > soccer::kPlayersPerTeam || type < -1) return std::nullopt;
    types[static_cast<std::size_t>(unum - 1)] = type;
  }

  if (!in.consume(')')) return std::nullopt;
  return types;
}

}  // namespace cls::player
