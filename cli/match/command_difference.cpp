// Reads the commands of a team from text logs.
#include "cli/match/command_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>

namespace cls::cli {
namespace {

// Cycle, stopped cycle and agent: uniform number, 12 for the coach.
using Decision = std::tuple<int, int, int>;

bool read_number(std::string_view& text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool skip(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

// "12,0\tRecv ada_9: (dash 100)(turn_neck 5)".
void add_line(std::string_view line, std::string_view sender,
              std::map<Decision, std::string>& commands) {
  constexpr int kCoach = 12;
  int cycle = 0;
  int stopped = 0;
  int agent = kCoach;
  if (!read_number(line, cycle) || !skip(line, ",") || !read_number(line, stopped)) return;
  if (!skip(line, "\t") || !skip(line, sender)) return;
  if (!skip(line, "Coach") && !read_number(line, agent)) return;
  if (!skip(line, ": ")) return;
  std::string& text = commands[{cycle, stopped, agent}];
  if (!text.empty()) text += ' ';
  text += line;
}

std::map<Decision, std::string> commands_of(std::string_view log, std::string_view name) {
  const std::string sender = fmt::format("Recv {}_", name);
  std::map<Decision, std::string> commands;
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    add_line(log.substr(0, end), sender, commands);
    log.remove_prefix(std::min(end + 1, log.size()));
  }
  return commands;
}

}  // namespace

std::optional<CommandDifference> compare_commands(std::string_view before, std::string_view now,
                                                  std::string_view name) {
  constexpr int kPlayers = 11;
  const auto old_commands = commands_of(before, name);
  const auto new_commands = commands_of(now, name);
  std::map<Decision, std::pair<std::string_view, std::string_view>> all;
  for (const auto& [decision, text] : old_commands) all[decision].first = text;
  for (const auto& [decision, text] : new_commands) all[decision].second = text;
  std::optional<CommandDifference> difference;
  for (const auto& [decision, texts] : all) {
    if (texts.first == texts.second) continue;
    if (!difference) {
      const int agent = std::get<2>(decision);
      difference.emplace();
      difference->cycle = std::get<0>(decision);
      difference->agent = agent > kPlayers ? "the coach" : fmt::format("player {}", agent);
      difference->before = texts.first;
      difference->now = texts.second;
      difference->total =
          static_cast<std::int64_t>(std::max(old_commands.size(), new_commands.size()));
    }
    ++difference->differ;
  }
  return difference;
}

}  // namespace cls::cli
