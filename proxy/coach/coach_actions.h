// Executes the replies of GetCoachActions and GetTrainerActions as server commands.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"
#include "proxy/coach/coach_memory.h"
#include "proxy/connection/action_names.h"
#include "soccer/commands/coach_command.h"

namespace cls::proxy {

/// Index: field number in CoachAction or TrainerAction; 0: without a known member.
constexpr int kCoachActionKinds = 7;

/// Results of the requested actions.
struct CoachActionReport {
  std::array<std::int64_t, kCoachActionKinds> done{};  ///< a command was issued, or none was needed
  std::array<std::int64_t, kCoachActionKinds>
      invalid{};  ///< unknown player, type or play mode; NaN
  std::int64_t unknown = 0;
};

/// Counts by outcome ("executed", "invalid", "unimplemented"), without zeros, by action name.
ActionOutcomes outcomes_by_name(const CoachActionReport& report, bool is_trainer);

/// Appends the commands in the order of the list. An unknown uniform number or type, a coordinate
/// that is not finite, or a play mode that the server lacks makes no command.
void execute(const protos::CoachActions& actions, const player::WorldModel& world,
             CoachMemory& memory, CoachActionReport& report,
             std::vector<soccer::CoachCommand>& out);
void execute(const protos::TrainerActions& actions, const player::WorldModel& world,
             CoachActionReport& report, std::vector<soccer::CoachCommand>& out);

}  // namespace cls::proxy
