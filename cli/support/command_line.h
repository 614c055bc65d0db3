// The command line of this process.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// The program and its arguments, as the user typed them.
std::vector<std::string> command_line();

/// The same as a line of sh, without --force: it resumes what the process left incomplete.
std::string resume_command();

/// The file of this program, to start it again.
base::Result<std::string> own_program();

}  // namespace cls::cli
