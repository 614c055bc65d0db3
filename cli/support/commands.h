// The commands of `cls`: one function per command, each in its own .cpp file.
#pragma once

namespace CLI {
class App;
}

namespace cls::cli {

// Each function adds its command to `app`. When the command runs, it stores its exit code in
// `exit_code`, which must outlive `app`.

void add_match_command(CLI::App& app, int& exit_code);
void add_tournament_command(CLI::App& app, int& exit_code);
void add_tune_command(CLI::App& app, int& exit_code);
void add_tune_run_command(CLI::App& app, int& exit_code);
void add_tune_status_command(CLI::App& app, int& exit_code);
void add_tune_report_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_completion_command(CLI::App& app, int& exit_code);
void add_config_command(CLI::App& app, int& exit_code);
void add_dev_command(CLI::App& app, int& exit_code);
void add_explain_command(CLI::App& app, int& exit_code);
void add_help_command(CLI::App& app, int& exit_code);
void add_init_command(CLI::App& app, int& exit_code);
void add_new_command(CLI::App& app, int& exit_code);
void add_report_command(CLI::App& app, int& exit_code);
void add_package_team_command(CLI::App& app, int& exit_code);
void add_results_command(CLI::App& app, int& exit_code);
void add_stats_command(CLI::App& app, int& exit_code);
void add_logs_command(CLI::App& app, int& exit_code);
void add_convert_command(CLI::App& app, int& exit_code);
void add_watch_command(CLI::App& app, int& exit_code);
void add_check_command(CLI::App& app, int& exit_code);
void add_doctor_command(CLI::App& app, int& exit_code);
void add_mock_command(CLI::App& app, int& exit_code);
void add_proxy_command(CLI::App& app, int& exit_code);
void add_server_command(CLI::App& app, int& exit_code);
void add_test_command(CLI::App& app, int& exit_code);
void add_train_command(CLI::App& app, int& exit_code);
void add_version_command(CLI::App& app, int& exit_code);

// Sub-commands; `app` is the command `check`.
void add_check_playmaker_command(CLI::App& app, int& exit_code);
void add_check_server_command(CLI::App& app, int& exit_code);
void add_check_server_log_command(CLI::App& app, int& exit_code);
void add_check_perception_command(CLI::App& app, int& exit_code);

// Sub-commands; `app` is the command `tournament`.
void add_tournament_plan_command(CLI::App& app, int& exit_code);
void add_tournament_run_command(CLI::App& app, int& exit_code);
void add_tournament_work_command(CLI::App& app, int& exit_code);
void add_tournament_status_command(CLI::App& app, int& exit_code);
void add_tournament_report_command(CLI::App& app, int& exit_code);
void add_tournament_stop_command(CLI::App& app, int& exit_code);

}  // namespace cls::cli
