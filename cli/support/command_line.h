// The command line of this process.
#pragma once

#include <string>
#include <vector>

namespace cls::cli {

/// The program and its arguments, as the user typed them.
std::vector<std::string> command_line();

/// The same as a line of sh, without --force: it resumes what the process left incomplete.
std::string resume_command();

}  // namespace cls::cli
