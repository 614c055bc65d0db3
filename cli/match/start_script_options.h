// The options of the start scripts of the Cross Language Soccer framework's proxy that `cls proxy`
// does not have under its own names: logs for soccerwindow2, the team graphic, what is refused.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"
#include "match/standalone_team.h"

namespace cls::cli {

/// Values of the options, in the units of the scripts.
struct StartScriptValues {
  bool debug = false;
  std::string log_dir = "/tmp";
  std::string debug_log_ext = ".log";
  int debug_start_time = -1;
  int debug_end_time = 99'999'999;
  bool debug_server_connect = false;
  bool debug_server_logging = false;
  std::string debug_server_host;  ///< empty: the soccer server's
  int debug_server_port = 0;      ///< 0: see kDebugPortOffset
  bool offline_logging = false;
  std::string team_graphic;
  std::string fullstate = "reference";
};

/// The debug server's port, counted from the soccer server's.
inline constexpr int kDebugPortOffset = 32;

/// Adds the options; their values go to `values` and Option::given.
void add_start_script_options(Command& command, StartScriptValues& values);

/// Applies the values; returns a line for each that is refused, each with what to do instead.
std::vector<std::string> apply_start_script_options(const Command& command,
                                                    const StartScriptValues& values,
                                                    match::StandaloneTeamOptions& options);

/// A line for each given option that only changes another one, which was not given.
std::vector<std::string> start_script_warnings(const Command& command);

}  // namespace cls::cli
