// Picks the lines of agents.
#include "cli/logs/agent_commands.h"

namespace cls::cli {

std::vector<AgentCommand> agent_commands(const gamelog::RclRecord& log) {
  std::vector<AgentCommand> commands;
  for (const gamelog::RclLine& line : log.lines) {
    const bool is_coach = line.source == gamelog::RclSource::kCoach;
    if (!is_coach && line.source != gamelog::RclSource::kPlayer) continue;
    commands.push_back({.time = line.time,
                        .stopped = line.stopped,
                        .team = line.team,
                        .agent = is_coach ? kCoachAgent : line.unum,
                        .text = log.text_of(line)});
  }
  return commands;
}

}  // namespace cls::cli
