// Programs that tests use where they are installed.
#pragma once

#include <string>

#include "tests/support/command.h"

namespace cls::tests {

/// True if `program` is on PATH.
inline bool is_installed(const std::string& program) {
  return run({"/bin/sh", "-c", "command -v " + program}).exit_code == 0;
}

}  // namespace cls::tests
