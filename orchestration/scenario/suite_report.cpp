// Formats verdicts as text, JSON, JUnit and GitHub annotations.
#include "orchestration/scenario/suite_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/report/github.h"
#include "base/report/junit.h"
#include "base/system/version.h"

namespace cls::orchestration::scenario {
namespace {

using Json = nlohmann::ordered_json;

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPassed:
      return "passed";
    case Verdict::kFailed:
      return "failed";
    case Verdict::kSkipped:
      break;
  }
  return "skipped";
}

// "line 12, seed 3: {"score": ...}: the score is ..."
std::string describe(const CheckVerdict& check) {
  return fmt::format("line {}{}: {}: {}", check.line,
                     check.seed ? fmt::format(", seed {}", *check.seed) : "", check.name,
                     check.detail);
}

std::string failures(const ScenarioVerdict& verdict) {
  std::string text;
  for (const CheckVerdict& check : verdict.checks) {
    if (!check.passed) text += describe(check) + "\n";
  }
  if (!verdict.reason.empty()) text += verdict.reason + "\n";
  return text;
}

Json json_of(const CheckVerdict& check) {
  Json json = {{"name", check.name},
               {"line", check.line},
               {"passed", check.passed},
               {"held", check.held},
               {"runs", check.runs}};
  if (check.seed) {
    json["seed"] = *check.seed;
    json["detail"] = check.detail;
  }
  return json;
}

Json json_of(const ScenarioVerdict& verdict) {
  const Scenario& scenario = *verdict.scenario;
  Json json = {{"name", scenario.name},
               {"file", scenario.file},
               {"verdict", name(verdict.verdict)},
               {"seeds", verdict.seeds}};
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  json["checks"] = Json::array();
  for (const CheckVerdict& check : verdict.checks) json["checks"].push_back(json_of(check));
  if (!verdict.rerun.empty()) {
    json["repeat"] = verdict.rerun;
    json["replay"] = verdict.replay;
  }
  json["seconds"] = verdict.seconds;
  return json;
}

}  // namespace

std::string to_text(const ScenarioVerdict& verdict) {
  const Scenario& scenario = *verdict.scenario;
  if (verdict.verdict == Verdict::kSkipped) {
    return fmt::format("skip  {}: {}\n", scenario.name, verdict.reason);
  }
  const std::string runs =
      verdict.seeds.size() > 1 ? fmt::format("  ({} seeds)", verdict.seeds.size()) : "";
  if (verdict.verdict == Verdict::kPassed) return fmt::format("ok    {}{}\n", scenario.name, runs);
  std::string text = fmt::format("FAIL  {}{}\n", scenario.name, runs);
  if (!scenario.about.empty()) text += fmt::format("      {}\n", scenario.about);
  for (const CheckVerdict& check : verdict.checks) {
    if (!check.passed) text += fmt::format("      {}: {}\n", scenario.file, describe(check));
  }
  if (!verdict.reason.empty()) text += fmt::format("      {}\n", verdict.reason);
  if (!verdict.replay.empty()) text += fmt::format("      logs: {}\n", verdict.replay);
  return text + fmt::format("      rerun: {}\n", verdict.rerun);
}

std::string summary(const SuiteVerdict& suite, double seconds) {
  return fmt::format("{} passed, {} failed, {} skipped in {:.1f} s\n",
                     suite.count(Verdict::kPassed), suite.count(Verdict::kFailed),
                     suite.count(Verdict::kSkipped), seconds);
}

std::string to_json(const SuiteVerdict& suite) {
  Json json = {{"schema", "cls.test/1"},
               {"version", base::kVersion},
               {"passed", suite.count(Verdict::kPassed)},
               {"failed", suite.count(Verdict::kFailed)},
               {"skipped", suite.count(Verdict::kSkipped)}};
  json["scenarios"] = Json::array();
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    json["scenarios"].push_back(json_of(verdict));
  }
  return json.dump(2) + "\n";
}

std::string to_junit(const SuiteVerdict& suite) {
  std::vector<base::JunitCase> cases;
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    const Scenario& scenario = *verdict.scenario;
    base::JunitCase& one = cases.emplace_back();
    one.group = "scenarios";
    one.name = scenario.name;
    one.file = scenario.file;
    one.seconds = verdict.seconds;
    if (verdict.verdict == Verdict::kSkipped) {
      one.result = base::JunitCase::Result::kSkipped;
      one.message = verdict.reason;
    } else if (verdict.verdict == Verdict::kFailed) {
      const std::string lines = failures(verdict);
      one.result = base::JunitCase::Result::kFailed;
      one.type = "check";
      one.message = lines.substr(0, lines.find('\n'));
      one.text = fmt::format("{}rerun: {}\n", lines, verdict.rerun);
    }
  }
  return base::format_junit("cls test", cases);
}

std::string to_annotations(const SuiteVerdict& suite) {
  std::string text;
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    if (verdict.verdict != Verdict::kFailed) continue;
    const Scenario& scenario = *verdict.scenario;
    const auto add = [&](int line, const std::string& what) {
      text += base::format_github_error({scenario.file, line}, "scenario " + scenario.name,
                                        what + "\nrerun: " + verdict.rerun);
    };
    for (const CheckVerdict& check : verdict.checks) {
      if (!check.passed) add(check.line, describe(check));
    }
    if (!verdict.reason.empty()) add(1, verdict.reason);
  }
  return text;
}

}  // namespace cls::orchestration::scenario
