// `cls proxy`: a team of players alone, for any running soccer server.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Adds the command; its exit code goes to `exit_code`.
void add_proxy_command(CLI::App& app, int& exit_code);

}  // namespace cls::cli
