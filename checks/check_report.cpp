// Reports of checks.
#include "checks/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

#include "base/report/github.h"
#include "base/report/junit.h"
#include "base/text/enum_names.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::checks {
namespace {

constexpr auto kResultNames = base::enum_names<StepResult>("pass", "fail", "skip");

}  // namespace

Finding pass(std::string evidence) { return {StepResult::kPass, std::move(evidence)}; }
Finding fail(std::string evidence) { return {StepResult::kFail, std::move(evidence)}; }
Finding skip(std::string evidence) { return {StepResult::kSkip, std::move(evidence)}; }

CheckStep& run_step(CheckReport& report, std::string name, std::string why,
                    const std::function<Finding()>& run) {
  CheckStep& step = report.steps.emplace_back(CheckStep{std::move(name), std::move(why)});
  const auto start = std::chrono::steady_clock::now();
  Finding found = run();
  step.result = found.result;
  step.evidence = std::move(found.evidence);
  step.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return step;
}

int CheckReport::count(StepResult result) const {
  return static_cast<int>(
      std::ranges::count_if(steps, [result](const auto& step) { return step.result == result; }));
}

std::string to_text(const CheckStep& step) {
  const std::string_view result =
      step.result == StepResult::kFail ? "FAIL" : kResultNames.name(step.result);
  std::string text = fmt::format("{} {:26} {}\n", result, step.name, step.evidence);
  if (step.result == StepResult::kFail) text += fmt::format("     why: {}\n", step.why);
  return text;
}

std::string summary(const CheckReport& report) {
  return fmt::format("\n{}: {} of {} steps passed, {} failed, {} skipped\n", report.subject,
                     report.count(StepResult::kPass), report.steps.size(),
                     report.count(StepResult::kFail), report.count(StepResult::kSkip));
}

std::string to_json(const CheckReport& report) {
  base::Json document = {{"schema", report.schema},
                         {"subject", report.subject},
                         {"passed", report.passed()},
                         {"steps_passed", report.count(StepResult::kPass)},
                         {"steps_failed", report.count(StepResult::kFail)},
                         {"steps_skipped", report.count(StepResult::kSkip)}};
  base::Json& steps = document["steps"] = base::Json::array();
  for (const CheckStep& step : report.steps) {
    steps.push_back({{"name", step.name},
                     {"result", kResultNames.name(step.result)},
                     {"evidence", step.evidence},
                     {"why", step.why}});
  }

  return base::json_document(document);
}

std::string to_junit(const CheckReport& report) {
  std::vector<base::JunitCase> cases;
  for (const CheckStep& step : report.steps) {
    base::JunitCase& one = cases.emplace_back();
    one.group = fmt::format("{} {}", report.command, report.subject);
    one.name = step.name;
    one.seconds = step.seconds;

    if (step.result == StepResult::kPass) {
      one.text = step.evidence;
      continue;
    }

    const bool failed = step.result == StepResult::kFail;
    one.result = failed ? base::JunitCase::Result::kFailed : base::JunitCase::Result::kSkipped;
    one.message = step.evidence;
    if (failed) one.type = "step";
    if (failed) one.text = fmt::format("{}\nwhy: {}\n", step.evidence, step.why);
  }

  return base::format_junit(report.command, cases);
}

std::string to_annotations(const CheckReport& report) {
  std::string text;
  for (const CheckStep& step : report.steps) {
    if (step.result != StepResult::kFail) continue;
    text += base::format_github_error(
        {}, fmt::format("{} {}: {}", report.command, report.subject, step.name),
        fmt::format("{}\nwhy: {}", step.evidence, step.why));
  }
  return text;
}

}  // namespace cls::checks
