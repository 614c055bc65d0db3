// A program under test that has ended, in words for the steps that it failed.
#pragma once

#include <string>

#include "orchestration/process/process_host.h"

namespace cls::orchestration::checks {

/// "the program has ended (exit code 3); its last words: cannot load the formation", where `what`
/// is "the program"; empty while it has not ended.
std::string account_of_end(const std::string& what, const process::Child& child);

}  // namespace cls::orchestration::checks
