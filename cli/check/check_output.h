// Output of `cls check playmaker` and `cls check server`.
#pragma once

#include <functional>

#include "checks/check_report.h"
#include "cli/command/command.h"
#include "cli/support/ci_reports.h"

namespace cls::cli {

struct CheckOutput {
  bool json = false;
  bool strict = false;
  bool quiet = false;
  CiReports reports;
};

/// --json, --strict, --quiet and those of CI reports.
void add_check_output_options(Command& command, CheckOutput& output);

/// Prints each finished step to stdout: none with --json, only failures with --quiet.
std::function<void(const checks::CheckStep&)> step_printer(const CheckOutput& output);

/// Prints the report and writes the CI reports. Returns the exit code; `signal` is the signal that
/// interrupted the check, or 0.
int finish_check(const checks::CheckReport& report, const CheckOutput& output, int signal);

}  // namespace cls::cli
