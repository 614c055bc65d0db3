// `cls tournament`: plan, run, status, report, stop, work.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

/// Adds the command to `app`; when it runs it stores its exit code in `exit_code`, which must
/// outlive `app`.
void add_tournament_command(CLI::App& app, int& exit_code);

/// Its parts; `app` is the command `tournament`.
void add_tournament_plan_command(CLI::App& app, int& exit_code);
void add_tournament_run_command(CLI::App& app, int& exit_code);
void add_tournament_work_command(CLI::App& app, int& exit_code);
void add_tournament_status_command(CLI::App& app, int& exit_code);
void add_tournament_report_command(CLI::App& app, int& exit_code);
void add_tournament_stop_command(CLI::App& app, int& exit_code);

}  // namespace cls::cli
