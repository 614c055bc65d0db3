// Output of `cls check playmaker` and `cls check server`.
#include "cli/check/check_output.h"

#include <fmt/format.h>

#include <cstdio>

#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"

namespace cls::cli {

using orchestration::checks::CheckReport;
using orchestration::checks::CheckStep;
using orchestration::checks::StepResult;

std::function<void(const CheckStep&)> step_printer(bool json) {
  return [json](const CheckStep& step) {
    if (json) return;
    fmt::print("{}", to_text(step));
    std::fflush(stdout);
  };
}

int finish_check(const CheckReport& report, bool json, const CiReports& ci_reports, int signal) {
  fmt::print("{}", json ? to_json(report) : summary(report));
  const ExitCode written = write_ci_reports(ci_reports, to_junit(report), to_annotations(report));
  if (written != kOk) return written;
  if (signal != 0) return signal_exit_code(signal);
  if (report.steps.front().result != StepResult::kPass) return kUnavailable;
  return report.passed() ? kOk : kFailed;
}

}  // namespace cls::cli
