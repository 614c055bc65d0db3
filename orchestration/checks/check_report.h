// Named steps of a conformance check: what was tried, what came of it, why it matters.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cls::orchestration::checks {

enum class StepResult { kPass, kFail, kSkip };

/// What a step found.
struct Finding {
  StepResult result = StepResult::kPass;
  std::string evidence;
};
Finding pass(std::string evidence = {});
Finding fail(std::string evidence);
Finding skip(std::string evidence);

struct CheckStep {
  std::string name;  ///< "register_identity"
  std::string why;   ///< one sentence: why it matters
  StepResult result = StepResult::kSkip;
  std::string evidence;  ///< what was seen
  double seconds = 0.0;  ///< that it took
};

/// Takes a step: what it finds, and how long that takes, is written down.
void take(CheckStep& step, const std::function<Finding()>& run);

struct CheckReport {
  std::string schema;   ///< of the JSON document
  std::string command;  ///< "cls check playmaker"
  std::string subject;  ///< what was checked, as the user named it
  std::vector<CheckStep> steps;

  int count(StepResult result) const;
  bool passed() const { return count(StepResult::kFail) == 0; }
};

/// A line for a step, and under it, if it failed, why it matters.
std::string to_text(const CheckStep& step);
/// The last line: how many steps passed.
std::string summary(const CheckReport& report);
std::string to_json(const CheckReport& report);
std::string to_junit(const CheckReport& report);
/// Annotations of GitHub Actions, one for each failed step.
std::string to_annotations(const CheckReport& report);

}  // namespace cls::orchestration::checks
