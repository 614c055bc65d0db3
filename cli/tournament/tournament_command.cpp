// The list of the parts.
#include "cli/tournament/tournament_command.h"

#include <CLI/CLI.hpp>

namespace cls::cli {
namespace {

constexpr const char* kDescription =
    "Plays many matches after a plan, keeps every result, tells who is better.\n"
    "\n"
    "  cls init                       writes a commented cls.toml: teams, format, rounds\n"
    "  cls tournament plan DIR        lists the matches without playing\n"
    "  cls tournament run DIR         plays them; called again it goes on where it ended\n"
    "  cls tournament status DIR      how far it is\n"
    "  cls tournament report DIR      tables and statistics\n"
    "  cls tournament stop DIR        ends a run after the matches under way\n"
    "\n"
    "docs/tournaments.md leads from two Playmakers to a verdict.";

}  // namespace

void add_tournament_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("tournament", kDescription);
  command->require_subcommand(1);
  add_tournament_plan_command(*command, exit_code);
  add_tournament_run_command(*command, exit_code);
  add_tournament_status_command(*command, exit_code);
  add_tournament_report_command(*command, exit_code);
  add_tournament_stop_command(*command, exit_code);
  add_tournament_work_command(*command, exit_code);
}

}  // namespace cls::cli
