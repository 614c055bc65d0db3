// From the replies of GetCoachActions and GetTrainerActions to commands for the server.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/coach/coach_notes.h"
#include "proxy/world/world_model.h"
#include "soccer/commands/coach_command.h"

namespace cls::proxy {

/// Actions by their number in CoachAction or TrainerAction; 0: without a member that is known.
constexpr int kCoachActionKinds = 7;

/// What became of what was asked for.
struct CoachReport {
  std::array<std::int64_t, kCoachActionKinds> done{};     ///< at least one command, or none needed
  std::array<std::int64_t, kCoachActionKinds> invalid{};  ///< no such player, type or mode; NaN
  std::int64_t unknown = 0;
};

/// Appends the commands in the order of the list. A number that nobody has, a type that there is
/// not, a coordinate that is no number or a mode that the server has no word for makes no command.
void carry_out(const protos::CoachActions& actions, const WorldModel& world, CoachNotes& notes,
               CoachReport& report, std::vector<soccer::CoachCommand>& out);
void carry_out(const protos::TrainerActions& actions, const WorldModel& world, CoachReport& report,
               std::vector<soccer::CoachCommand>& out);

}  // namespace cls::proxy
