// Output of `cls check playmaker` and `cls check server`.
#include "cli/check/check_output.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"

namespace cls::cli {

using checks::CheckReport;
using checks::CheckStep;
using checks::StepResult;

void add_check_output_options(Command& command, CheckOutput& output) {
  command.flag("--json", output.json, "print one JSON document instead of text")
      .of_group(kOutputGroup);
  add_ci_options(command, output.reports);
  command.flag("--strict", output.strict, "fail (exit 1) on any skipped step")
      .of_group(kOutputGroup);
  command.flag("--quiet", output.quiet, "print only failures and the summary")
      .of_group(kOutputGroup);
}

std::function<void(const CheckStep&)> step_printer(const CheckOutput& output) {
  // The first step reaches the subject. Without it all others are skipped.
  return [&output, first = true, reached = true](const CheckStep& step) mutable {
    if (!reached) return;
    if (std::exchange(first, false)) reached = step.result == StepResult::kPass;
    if (output.json || (output.quiet && step.result != StepResult::kFail)) return;

    fmt::print("{}", to_text(step));
    std::fflush(stdout);
  };
}

int finish_check(const CheckReport& report, const CheckOutput& output, int signal) {
  fmt::print("{}", output.json ? to_json(report) : summary(report));
  const ExitCode written =
      write_ci_reports(output.reports, {to_junit(report), to_annotations(report)});

  if (written != kOk) return written;
  if (signal != 0) return signal_exit_code(signal);
  if (report.steps.front().result != StepResult::kPass) return kUnavailable;
  if (!report.passed()) return kFailed;

  const int skipped = report.count(StepResult::kSkip);
  if (!output.strict || skipped == 0) return kOk;
  return print_error(kFailed, "{} skipped (--strict)", skipped);
}

}  // namespace cls::cli
