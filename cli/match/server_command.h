// `cls server`: the embedded soccer server alone.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Adds the command; its exit code goes to `exit_code`.
void add_server_command(CLI::App& app, int& exit_code);

}  // namespace cls::cli
