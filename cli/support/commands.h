// The commands of `cls`: a function add_NAME_command() for each, in its own .cpp file.
#pragma once

#include "cli/command/command.h"

/// The commands below `cls`, in the order of its help.
#define CLS_COMMANDS(ROW) \
  ROW(match)              \
  ROW(tournament)         \
  ROW(tune)               \
  ROW(compare)            \
  ROW(test)               \
  ROW(dev)                \
  ROW(results)            \
  ROW(stats)              \
  ROW(review)             \
  ROW(logs)               \
  ROW(convert)            \
  ROW(book)               \
  ROW(challenge)          \
  ROW(dataset)            \
  ROW(watch)              \
  ROW(report)             \
  ROW(check)              \
  ROW(doctor)             \
  ROW(mock)               \
  ROW(proxy)              \
  ROW(server)             \
  ROW(explain)            \
  ROW(config)             \
  ROW(init)               \
  ROW(new)                \
  ROW(package_team)       \
  ROW(qualify)            \
  ROW(completion)         \
  ROW(train)              \
  ROW(version)            \
  ROW(help)

/// Those below `cls check`, `cls tournament` and `cls tune`.
#define CLS_CHECK_COMMANDS(ROW) \
  ROW(check_playmaker) ROW(check_server) ROW(check_server_log) ROW(check_perception)
#define CLS_TOURNAMENT_COMMANDS(ROW) \
  ROW(tournament_check_in)           \
  ROW(tournament_plan)               \
  ROW(tournament_run)                \
  ROW(tournament_status)             \
  ROW(tournament_report)             \
  ROW(tournament_stop)               \
  ROW(tournament_pause)              \
  ROW(tournament_resume)             \
  ROW(tournament_decide)             \
  ROW(tournament_archive)            \
  ROW(tournament_watch)              \
  ROW(tournament_work)
#define CLS_TUNE_COMMANDS(ROW) ROW(tune_init) ROW(tune_run) ROW(tune_status) ROW(tune_report)

/// A row that adds the command to `parent`.
#define CLS_ADD_COMMAND(name) add_##name##_command(parent);
#define CLS_DECLARE_COMMAND(name) void add_##name##_command(Command& parent);

namespace cls::cli {

CLS_COMMANDS(CLS_DECLARE_COMMAND)
CLS_CHECK_COMMANDS(CLS_DECLARE_COMMAND)
CLS_TOURNAMENT_COMMANDS(CLS_DECLARE_COMMAND)
CLS_TUNE_COMMANDS(CLS_DECLARE_COMMAND)

}  // namespace cls::cli
