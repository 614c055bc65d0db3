// The commands of `cls`: one function per command, each in its own .cpp file.
#pragma once

#include "cli/command/command.h"

namespace cls::cli {

// Each function adds its command to `app`; `Command::run` returns the exit code.

void add_match_command(Command& app);
void add_tournament_command(Command& app);
void add_tune_command(Command& app);
void add_tune_run_command(Command& app);
void add_tune_status_command(Command& app);
void add_tune_report_command(Command& app);
void add_book_command(Command& app);
void add_challenge_command(Command& app);
void add_compare_command(Command& app);
void add_completion_command(Command& app);
void add_config_command(Command& app);
void add_dev_command(Command& app);
void add_explain_command(Command& app);
void add_help_command(Command& app);
void add_init_command(Command& app);
void add_new_command(Command& app);
void add_report_command(Command& app);
void add_package_team_command(Command& app);
void add_qualify_command(Command& app);
void add_results_command(Command& app);
void add_stats_command(Command& app);
void add_logs_command(Command& app);
void add_convert_command(Command& app);
void add_watch_command(Command& app);
void add_check_command(Command& app);
void add_dataset_command(Command& app);
void add_doctor_command(Command& app);
void add_mock_command(Command& app);
void add_proxy_command(Command& app);
void add_server_command(Command& app);
void add_test_command(Command& app);
void add_train_command(Command& app);
void add_version_command(Command& app);

// Sub-commands; `app` is the command `check`.
void add_check_playmaker_command(Command& app);
void add_check_server_command(Command& app);
void add_check_server_log_command(Command& app);
void add_check_perception_command(Command& app);

// Sub-commands; `app` is the command `tournament`.
void add_tournament_plan_command(Command& app);
void add_tournament_run_command(Command& app);
void add_tournament_watch_command(Command& app);
void add_tournament_work_command(Command& app);
void add_tournament_status_command(Command& app);
void add_tournament_report_command(Command& app);
void add_tournament_stop_command(Command& app);
void add_tournament_archive_command(Command& app);
void add_tournament_pause_command(Command& app);
void add_tournament_resume_command(Command& app);
void add_tournament_decide_command(Command& app);
void add_tournament_check_in_command(Command& app);

}  // namespace cls::cli
