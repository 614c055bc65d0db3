// Reads the lines from their ends: only the name may contain spaces.
#include "viewer/decisions/decision_plan.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/text/lines.h"
#include "base/text/number_text.h"
#include "soccer/side.h"

namespace cls::viewer {
namespace {

constexpr std::string_view kRoom = " room ";

/// Removes the last word with the space before it; empty: there is none.
std::string_view take_last_word(std::string_view& line) {
  const std::size_t space = line.rfind(' ');
  if (space == std::string_view::npos) return {};
  const std::string_view word = line.substr(space + 1);
  line.remove_suffix(word.size() + 1);
  return word;
}

/// Removes " (12.3, -4)" from the end.
std::optional<soccer::Vec2> take_target(std::string_view& line) {
  const std::size_t open = line.ends_with(')') ? line.rfind(" (") : std::string_view::npos;
  if (open == std::string_view::npos) return std::nullopt;
  const std::string_view inside = line.substr(open + 2, line.size() - open - 3);
  const std::size_t comma = std::min(inside.find(", "), inside.size());
  const auto x = base::parse_number(inside.substr(0, comma));
  const auto y = comma < inside.size() ? base::parse_number(inside.substr(comma + 2)) : x;
  if (!x || !y || comma == inside.size()) return std::nullopt;
  line.remove_suffix(line.size() - open);
  return soccer::Vec2{*x, *y};
}

std::optional<ConsideredAction> parse_line(std::string_view line) {
  if (!line.starts_with("* ") && !line.starts_with("- ")) return std::nullopt;
  ConsideredAction action;
  action.chosen = line[0] == '*';
  line.remove_prefix(2);

  if (const std::size_t room = line.rfind(kRoom); room != std::string_view::npos) {
    action.room = base::parse_number(line.substr(room + kRoom.size()));
    line = line.substr(0, room);
  }

  std::string_view value = take_last_word(line);
  action.is_share = value.ends_with('%');
  if (action.is_share) value.remove_suffix(1);
  const auto number = base::parse_number(value);
  if (!number) return std::nullopt;
  action.value = *number;

  action.target = take_target(line);
  std::string_view name = line;
  const auto unum = base::parse_int(take_last_word(name));
  if (unum && soccer::is_unum(*unum)) {
    action.unum = *unum;
    line = name;
  }
  action.name = line;
  return line.empty() ? std::nullopt : std::optional(std::move(action));
}

}  // namespace

std::vector<ConsideredAction> considered_actions(std::string_view plan) {
  std::vector<ConsideredAction> actions;
  for (const std::string_view line : base::lines_of(plan)) {
    if (auto action = parse_line(line)) actions.push_back(*std::move(action));
  }
  std::ranges::stable_sort(actions, [](const ConsideredAction& a, const ConsideredAction& b) {
    return std::tie(a.value, a.chosen) > std::tie(b.value, b.chosen);
  });
  return actions;
}

}  // namespace cls::viewer
