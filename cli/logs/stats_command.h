// `cls stats`: what happened in matches, in figures.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Adds the command to `app`; when it runs it stores its exit code in `exit_code`, which must
/// outlive `app`.
void add_stats_command(CLI::App& app, int& exit_code);

}  // namespace cls::cli
