// Formats and parses player_types messages.
#include "player/perception/player_types_message.h"

#include <limits>

#include "base/index.h"
#include "soccer/protocol/scanner.h"

namespace cls::player {
namespace {

constexpr std::string_view kHead = "(player_types";

/// Skips spaces, then consumes `wanted` if it is next.
bool consume(soccer::Scanner& in, std::string_view wanted) {
  while (in.optional(" ")) continue;
  return in.optional(wanted);
}

bool parse_number(soccer::Scanner& in, int low, int high, int& number) {
  return consume(in, "") && in.integer(number, low, high);
}

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

  constexpr int kMaxType = std::numeric_limits<int>::max() - 1;  // larger ones do not fit
  soccer::Scanner in(text.substr(start + kHead.size()));
  TypeIds types;
  types.fill(-1);

  while (consume(in, "(")) {
    int unum = 0;
    int type = 0;
    if (!parse_number(in, 1, soccer::kPlayersPerTeam, unum) ||
        !parse_number(in, -1, kMaxType, type) || !consume(in, ")")) {
      return std::nullopt;
    }
    types[base::index(unum - 1)] = type;
  }

  if (!consume(in, ")")) return std::nullopt;
  return types;
}

}  // namespace cls::player
