// `run:COMMAND` sides: a shell command that starts a Playmaker.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "process/command_plan.h"
#include "soccer/side.h"

namespace cls::match {

/// Values of the placeholders {port}, {side}, {name} and {seed}.
struct RunValues {
  int port = 0;
  soccer::Side side = soccer::Side::kLeft;  ///< formatted as left, right or, if neutral, trainer
  std::string team_name;
  std::uint64_t seed = 0;
  std::string part = {};  ///< of a mixed side: its agents, "2-5,coach"; not a placeholder
};

/// An error if the command is empty, lacks {port}, or has a mistyped placeholder.
base::Result<void> check_run_command(std::string_view command);

/// The command with its placeholders replaced, each value quoted for the shell. ${side} with a '$'
/// is left to the shell.
std::string fill_in(std::string_view command, const RunValues& values);

/// The name of the Playmaker of a side for processes and results: "left Playmaker"; of a part of a
/// mixed side: "left Playmaker (2-5)".
std::string playmaker_name(soccer::Side side, std::string_view part = {});

/// The plan that starts the Playmaker of a side; its log in `folder` is named after side and part.
process::CommandPlan run_plan(std::string_view command, const RunValues& values,
                              const std::filesystem::path& folder);

/// The name of the program in a command, for a team name: "playmaker" for
/// `cd team && python3 -u playmaker.py --port {port}`. Empty: the script `run` of a project, which
/// has the name of its folder.
std::string program_in(std::string_view command);

/// The folder of the script `run` in a command: "../old" for `../old/run` and `cd ../old && ./run`;
/// "." if there is none.
std::string folder_in(std::string_view command);

}  // namespace cls::match
