// Output of `cls check playmaker` and `cls check server`.
#pragma once

#include <functional>

#include "cli/support/ci_reports.h"
#include "orchestration/checks/check_report.h"

namespace cls::cli {

/// Prints each finished step to stdout; prints nothing with `json`.
std::function<void(const orchestration::checks::CheckStep&)> step_printer(bool json);

/// Prints the report and writes the CI reports. Returns the exit code; `signal` is the signal that
/// interrupted the check, or 0.
int finish_check(const orchestration::checks::CheckReport& report, bool json,
                 const CiReports& ci_reports, int signal);

}  // namespace cls::cli
