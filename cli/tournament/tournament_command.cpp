// `cls tournament`: the list of its sub-commands.
#include "cli/support/commands.h"

namespace cls::cli {
namespace {

constexpr const char* kTournamentDescription =
    "play a tournament, store each result, rank the teams\n"
    "\n"
    "  cls init                     write a commented cls.toml: teams, format, rounds\n"
    "  cls tournament check-in DIR  start every team once, before the first match\n"
    "  cls tournament plan DIR      list the fixtures\n"
    "  cls tournament run DIR       play them; run again to resume\n"
    "  cls tournament status DIR    show progress and standings\n"
    "  cls tournament report DIR    print tables and statistics\n"
    "  cls tournament stop DIR      stop a run after its current matches\n"
    "  cls tournament pause DIR     begin a technical time-out; resume DIR ends it\n"
    "  cls tournament watch DIR     serve a page for spectators\n"
    "  cls tournament decide DIR    annul, award or repeat a match, with a reason\n"
    "  cls tournament archive DIR   write all logs under the names of the league\n"
    "\n"
    "docs/tournaments.md is a tutorial: from two Playmakers to a result.";

}  // namespace

void add_tournament_command(Command& app) {
  Command& parent = app.command("tournament", kTournamentDescription);
  parent.group = kPlayCommands;
  parent.starts_programs = true;
  CLS_TOURNAMENT_COMMANDS(CLS_ADD_COMMAND)
}

}  // namespace cls::cli
