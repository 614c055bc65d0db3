// Error output of the commands that read logs.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/files/log_files.h"
#include "gamelog/record/parse_errors.h"

namespace cls::cli {

/// Prints the first errors, one line each, and the number of further errors to stderr.
void report_errors(std::string_view path, const gamelog::ParseErrors& errors);

/// Prints a line for each argument that matches no log. Returns kOk or kNoInput.
int report_missing(const gamelog::FoundLogs& found);

/// Prints why one of several logs could not be opened (`unreadable`, empty: it could) and its parse
/// errors. Returns the updated exit code.
int report_log(int exit_code, const std::string& unreadable, std::string_view path,
               const gamelog::ParseErrors& errors);

/// The exit code for a log or page that could not be read: kNoInput if it cannot be opened,
/// kBadData if its contents are corrupt.
int unreadable_code(const std::string& path);

}  // namespace cls::cli
