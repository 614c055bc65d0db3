// `cls check server`: conformance of a soccer server, in named steps.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Adds the command to `check`; when it runs it stores its exit code in `exit_code`, which must
/// outlive `check`.
void add_check_server_command(CLI::App& check, int& exit_code);

}  // namespace cls::cli
