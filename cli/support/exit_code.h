// Exit codes of `cls`: the one place in the code; the manual has the same table.
#pragma once

namespace cls::cli {

/// What a script reads from `$?`. Values from 65 on are those of sysexits.h, above 100 those that
/// shells and timeout(1) use.
enum ExitCode : int {
  kDone = 0,            ///< finished; a test or check passed
  kAnswerIsNo = 1,      ///< a test or check failed; the match is invalid by what happened in play
  kUsage = 2,           ///< unknown option, command or side form; bad value; wrong argument count
  kBadData = 65,        ///< a log, script or transcript that cannot be understood
  kNoInput = 66,        ///< no such input
  kUnavailable = 69,    ///< a Playmaker or server refused or was not reached in time
  kInternalError = 70,  ///< a fault of ours
  kCannotCreate = 73,   ///< a file or folder cannot be created
  kWriteFailed = 74,    ///< a later write failed
  kTryAgain = 75,       ///< a fixed port is taken
  kBadConfig = 78,      ///< a configuration file with a mistake
  kTimedOut = 124,      ///< the time limit ended it
  kInterrupted = 130,   ///< SIGINT; what was played is written
  kTerminated = 143,    ///< SIGTERM; what was played is written
};

}  // namespace cls::cli
