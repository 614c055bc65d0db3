// Reports of checks.
#include "orchestration/checks/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace cls::orchestration {
namespace {

const char* name(StepResult result) {
  switch (result) {
    case StepResult::kPass:
      return "pass";
    case StepResult::kFail:
      return "fail";
    default:
      return "skip";
  }
}

}  // namespace

Finding pass(std::string evidence) { return {StepResult::kPass, std::move(evidence)}; }
Finding fail(std::string evidence) { return {StepResult::kFail, std::move(evidence)}; }
Finding skip(std::string evidence) { return {StepResult::kSkip, std::move(evidence)}; }

int CheckReport::count(StepResult result) const {
  return static_cast<int>(std::count_if(
      steps.begin(), steps.end(), [result](const auto& step) { return step.result == result; }));
}

std::string to_text(const CheckStep& step) {
  const char* result = step.result == StepResult::kFail ? "FAIL" : name(step.result);
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
  nlohmann::ordered_json document = {{"schema", report.schema},
                                     {"subject", report.subject},
                                     {"passed", report.passed()},
                                     {"steps_passed", report.count(StepResult::kPass)},
                                     {"steps_failed", report.count(StepResult::kFail)},
                                     {"steps_skipped", report.count(StepResult::kSkip)}};
  nlohmann::ordered_json& steps = document["steps"] = nlohmann::ordered_json::array();
  for (const CheckStep& step : report.steps) {
    steps.push_back({{"name", step.name},
                     {"result", name(step.result)},
                     {"evidence", step.evidence},
                     {"why", step.why}});
  }
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace cls::orchestration
