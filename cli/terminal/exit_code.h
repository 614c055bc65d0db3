// Exit codes of `cls`; docs/cli.md has the same table, and a test compares them.
#pragma once

namespace cls::cli {

/// Values from 65 on are those of sysexits.h; values above 100 those of shells and timeout(1).
enum ExitCode : int {
  kOk = 0,              ///< finished; a test or check passed
  kFailed = 1,          ///< a test or check failed; the match is invalid
  kUsage = 2,           ///< unknown option, command or side; bad value; wrong argument count
  kUndecided = 3,       ///< `cls compare` or `cls tune` ended without a verdict
  kBadData = 65,        ///< corrupt log, script or transcript
  kNoInput = 66,        ///< input not found
  kUnavailable = 69,    ///< a Playmaker or server refused or was unreachable until the timeout
  kInternalError = 70,  ///< a bug in cls
  kCannotCreate = 73,   ///< a file or folder cannot be created
  kWriteFailed = 74,    ///< a later write failed
  kTryAgain = 75,       ///< a fixed port is in use
  kBadConfig = 78,      ///< invalid configuration file
  kTimedOut = 124,      ///< time limit exceeded
  kInterrupted = 130,   ///< SIGINT; results so far are written
  kTerminated = 143,    ///< SIGTERM; results so far are written
};

}  // namespace cls::cli
