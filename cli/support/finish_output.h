// The end of all output of a command.
#pragma once

namespace cls::cli {

/// The exit code of the process whose command has ended with `exit_code`: a command whose output is
/// lost has failed, although its work is done. A reader that has left, such as head(1), knows that.
int finish_output(int exit_code);

}  // namespace cls::cli
