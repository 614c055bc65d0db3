// `run:COMMAND` sides: the user's own line of shell that starts a Playmaker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "orchestration/process/command_plan.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// What the placeholders {port}, {side}, {name} and {seed} stand for.
struct RunValues {
  int port = 0;
  soccer::Side side = soccer::Side::kLeft;  ///< written left, right or, neutral, trainer
  std::string team_name;
  std::uint64_t seed = 0;
};

/// An error when the command is empty, has no {port}, or a placeholder that looks mistyped.
base::Result<void> check_run_command(std::string_view command);

/// The command with its placeholders filled in, each value as one word of the shell. A '$' before
/// the brace keeps it as it is: ${side} is the shell's.
std::string fill_in(std::string_view command, const RunValues& values);

/// The plan that starts the Playmaker of a side, its log named after the side in `folder`.
process::CommandPlan run_plan(std::string_view command, const RunValues& values,
                              const std::filesystem::path& folder);

/// The name of what a command runs, for a team name: "playmaker" for
/// `cd brain && python3 -u playmaker.py --port {port}`. Empty when there is none.
std::string program_in(std::string_view command);

}  // namespace cls::orchestration::match
