// Steps and report of a conformance check.
#pragma once

#include <fmt/core.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace cls::checks {

enum class StepResult { kPass, kFail, kSkip };

/// Result of a step.
struct Finding {
  StepResult result = StepResult::kPass;
  std::string evidence;
};
Finding pass(std::string evidence = {});
Finding fail(std::string evidence);
Finding skip(std::string evidence);

template <class First, class... Rest>
Finding pass(fmt::format_string<First, Rest...> format, First&& first, Rest&&... rest) {
  return pass(fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...));
}
template <class First, class... Rest>
Finding fail(fmt::format_string<First, Rest...> format, First&& first, Rest&&... rest) {
  return fail(fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...));
}

struct CheckStep {
  std::string name;  ///< "register_identity"
  std::string why;   ///< one sentence: why it matters
  StepResult result = StepResult::kSkip;
  std::string evidence = {};  ///< what was observed
  double seconds = 0.0;       ///< wall time
};

struct CheckReport {
  std::string schema;   ///< of the JSON document
  std::string command;  ///< "cls check playmaker"
  std::string subject;  ///< what was checked, as given by the user
  std::vector<CheckStep> steps;

  int count(StepResult result) const;
  bool passed() const { return count(StepResult::kFail) == 0; }
};

/// Adds a step to the report; runs it, and stores its result and wall time.
CheckStep& run_step(CheckReport& report, std::string name, std::string why,
                    const std::function<Finding()>& run);

/// One line per step; a failed step has a second line: why it matters.
std::string to_text(const CheckStep& step);
/// Last line: number of steps passed, failed and skipped.
std::string summary(const CheckReport& report);
std::string to_json(const CheckReport& report);
std::string to_junit(const CheckReport& report);
/// GitHub Actions annotations, one per failed step.
std::string to_annotations(const CheckReport& report);

}  // namespace cls::checks
