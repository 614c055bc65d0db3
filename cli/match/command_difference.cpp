// Reads the commands of a team from text logs.
#include "cli/match/command_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/index.h"
#include "base/io/byte_source.h"
#include "cli/logs/agent_commands.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::cli {
namespace {

// Cycle, stopped cycle and agent.
using Decision = std::tuple<int, int, int>;

std::map<Decision, std::string> commands_of(std::string_view log, std::string_view name) {
  base::MemorySource source(log);
  const gamelog::RclRecord record = gamelog::read_rcl(source);

  std::map<Decision, std::string> commands;
  for (const AgentCommand& command : agent_commands(record)) {
    if (record.teams[base::index(command.team)] != name) continue;
    std::string& text = commands[{command.time, command.stopped, command.agent}];
    if (!text.empty()) text += ' ';
    text += command.text;
  }
  return commands;
}

}  // namespace

std::optional<CommandDifference> compare_commands(std::string_view before, std::string_view now,
                                                  std::string_view name) {
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
      difference->agent = agent == kCoachAgent ? "the coach" : fmt::format("player {}", agent);
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
