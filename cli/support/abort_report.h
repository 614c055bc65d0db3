// The last line of a process that a library, or an exception on another thread, ends.
#pragma once

#include <string>

namespace cls::cli {

/// From now on an abort prints why: an uncaught exception as print_exception() does, or that a
/// library ended the process, with the limits of memory and processes that are set. With a limit
/// of memory the exit code is kInternalError; else the abort follows, for debuggers and core files.
void report_aborts();

/// Why the limits of this shell are too low for `cls`, with the remedy; empty: they are not.
std::string too_low_limit();

}  // namespace cls::cli
