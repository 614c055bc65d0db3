// The characters of team names.
#include "soccer/protocol/team_names.h"

#include <fmt/format.h>

#include <utility>

#include "soccer/protocol/team_name.h"

namespace cls::soccer {
namespace {

using base::Error;
using base::Result;

constexpr std::string_view kCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_+";

constexpr std::string_view kSeparators = "-_+";

/// The end of a name that is too long; without the rest of a word, where enough follows it.
std::string end_of(const std::string& name) {
  const std::size_t cut = name.size() - TeamName::kMaxSize;
  const bool in_word = kSeparators.find(name[cut - 1]) == std::string_view::npos;
  const std::size_t separator = name.find_first_of(kSeparators, cut);
  constexpr std::size_t kEnough = TeamName::kMaxSize / 2;
  const bool follows = separator != std::string::npos && name.size() - separator > kEnough;
  return name.substr(in_word && follows && separator > cut ? separator + 1 : cut);
}

}  // namespace

Result<std::string> check_team_name(std::string_view name) {
  if (name.empty()) return Error{"a team name must not be empty"};
  if (name.size() > TeamName::kMaxSize) {
    return Error{
        fmt::format("team name '{}' is longer than {} characters", name, TeamName::kMaxSize)};
  }
  if (name.find_first_not_of(kCharacters) != std::string_view::npos) {
    return Error{fmt::format("team name '{}': only letters, digits, '-', '+' and '_'", name)};
  }
  return std::string(name);
}

std::string team_name_from(std::string_view text) {
  std::string name;
  for (const char c : text) name += kCharacters.find(c) != std::string_view::npos ? c : '_';
  if (name.size() > TeamName::kMaxSize) name = end_of(name);
  return name.empty() ? "team" : name;
}

TeamNames distinct_names(std::string left, std::string right) {
  if (left != right) return {std::move(left), std::move(right)};
  const std::string stem = left.substr(0, TeamName::kMaxSize - 2);
  return {stem + "_l", stem + "_r"};
}

}  // namespace cls::soccer
