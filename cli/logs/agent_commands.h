// What the players and coaches of a match sent, by its text log.
#pragma once

#include <compare>
#include <string_view>
#include <vector>

#include "gamelog/rcl/rcl_record.h"
#include "soccer/side.h"

namespace cls::cli {

inline constexpr int kCoachAgent = soccer::kPlayersPerTeam + 1;

/// A command with the clock of its reception.
struct AgentCommand {
  int time = 0;
  int stopped = 0;
  int team = 0;           ///< index into RclRecord::teams
  int agent = 0;          ///< the player's number; kCoachAgent: the online coach
  std::string_view text;  ///< of the record

  auto operator<=>(const AgentCommand&) const = default;
};

/// In the order of the log.
std::vector<AgentCommand> agent_commands(const gamelog::RclRecord& log);

}  // namespace cls::cli
