// Reads the parts of a mixed side.
#include "match/terms/mixed_side.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>
#include <utility>

#include "base/text/number_text.h"
#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "base/text/trimmed.h"
#include "proto/rpc.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using base::trimmed;

constexpr int kCoach = proto::kCoachNumber;
constexpr std::string_view kOthers = "others";

struct Role {
  std::string_view name;
  int first;
  int last;
};

// The numbers of the built-in formations.
constexpr std::array<Role, 6> kRoles = {{{"goalie", 1, 1},
                                         {"defenders", 2, 5},
                                         {"midfielders", 6, 8},
                                         {"forwards", 9, 11},
                                         {"players", 1, 11},
                                         {"coach", kCoach, kCoach}}};

// Length of "AGENTS=" at the begin of `text`; 0: another text, as after a `;` of a shell command.
std::size_t selector_length(std::string_view text) {
  constexpr std::string_view kSelector = "abcdefghijklmnopqrstuvwxyz0123456789-, \t\n";
  const std::size_t equals = text.find_first_not_of(kSelector);
  if (equals == std::string_view::npos || text[equals] != '=') return 0;
  return trimmed(text.substr(0, equals)).empty() ? 0 : equals + 1;
}

std::optional<int> parse_unum(std::string_view text) {
  const std::optional<int> unum = base::parse_int(text);
  return unum && soccer::is_unum(*unum) ? unum : std::nullopt;
}

Error unknown_agents(std::string_view word) {
  std::vector<std::string_view> names = {kOthers};
  for (const Role& role : kRoles) names.push_back(role.name);
  return Error{fmt::format(
      "'{}' is not a player{} (1 to 11, 2-5, goalie, defenders, midfielders, forwards, players, "
      "coach, others)",
      word, base::did_you_mean(word, names))};
}

// The numbers of one word: "9", "2-5", "forwards".
Result<std::pair<int, int>> parse_range(std::string_view word) {
  for (const Role& role : kRoles) {
    if (word == role.name) return std::pair(role.first, role.last);
  }
  const std::size_t dash = word.find('-');
  const auto first = parse_unum(word.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_unum(word.substr(dash + 1));
  if (!first || !last || *last < *first) return unknown_agents(word);
  return std::pair(*first, *last);
}

std::string agent(int number) {
  return number == kCoach ? std::string("the coach") : fmt::format("player {}", number);
}

// Splits at each `;` that precedes a selector.
Result<std::vector<MixedPart>> split_parts(std::string_view text) {
  std::vector<MixedPart> parts;
  std::string_view rest = text;
  while (true) {
    const std::size_t length = selector_length(rest);
    if (length == 0) return Error{fmt::format("'{}' is not AGENTS=SIDE", trimmed(rest))};

    std::size_t end = rest.find(';', length);
    while (end != std::string_view::npos && selector_length(rest.substr(end + 1)) == 0) {
      end = rest.find(';', end + 1);
    }

    const std::size_t side_length = end == std::string_view::npos ? end : end - length;
    parts.push_back({.label = std::string(trimmed(rest.substr(0, length - 1))),
                     .side = std::string(trimmed(rest.substr(length, side_length)))});
    if (end == std::string_view::npos) return parts;
    rest.remove_prefix(end + 1);
  }
}

}  // namespace

Result<std::vector<MixedPart>> parse_mixed_side(std::string_view text) {
  auto split_text = split_parts(text);
  if (!split_text) return split_text;
  std::vector<MixedPart>& parts = *split_text;
  std::map<int, std::size_t> owner;
  std::optional<std::size_t> others;

  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const std::string_view piece : base::split(parts[i].label, ',')) {
      const std::string_view word = trimmed(piece);
      if (word == kOthers) {
        if (others) return Error{"two parts are named others"};
        others = i;
        continue;
      }

      TRY_INIT(const auto range, parse_range(word));
      for (int number = range.first; number <= range.second; ++number) {
        if (!owner.emplace(number, i).second) {
          return Error{fmt::format("{} has two parts", agent(number))};
        }
      }
    }
  }

  for (int number = 1; number <= soccer::kPlayersPerTeam; ++number) {
    if (owner.contains(number)) continue;
    if (!others) return Error{fmt::format("player {} has no part; add others=SIDE", number)};
    owner.emplace(number, *others);
  }

  owner.emplace(kCoach, others.value_or(0));
  for (const auto& [number, part] : owner) parts[part].agents.push_back(number);
  for (const MixedPart& part : parts) {
    if (part.agents.empty()) return Error{fmt::format("no player is left for '{}'", part.label)};
  }
  return split_text;
}

}  // namespace cls::match
