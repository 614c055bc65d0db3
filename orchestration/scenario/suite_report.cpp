// Writing verdicts in four forms.
#include "orchestration/scenario/suite_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "orchestration/version.h"
#include "orchestration/xml.h"

namespace cls::orchestration {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Verdict verdict) {
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

// GitHub reads % and line ends as escapes; in properties also , and :.
std::string annotation(std::string_view text, bool property) {
  std::string escaped;
  for (const char c : text) {
    const bool special = c == '%' || c == '\n' || c == '\r' || (property && (c == ',' || c == ':'));
    escaped += special ? fmt::format("%{:02X}", c) : std::string(1, c);
  }
  return escaped;
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
               {"verdict", word(verdict.verdict)},
               {"seeds", verdict.seeds}};
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  json["checks"] = Json::array();
  for (const CheckVerdict& check : verdict.checks) json["checks"].push_back(json_of(check));
  if (!verdict.repeat.empty()) {
    json["repeat"] = verdict.repeat;
    json["replay"] = verdict.replay;
  }
  json["seconds"] = verdict.seconds;
  return json;
}

double total_seconds(const SuiteVerdict& suite) {
  double seconds = 0.0;
  for (const ScenarioVerdict& verdict : suite.scenarios) seconds += verdict.seconds;
  return seconds;
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
  return text + fmt::format("      again: {}\n", verdict.repeat);
}

std::string summary(const SuiteVerdict& suite, double seconds) {
  return fmt::format("{} passed, {} failed, {} skipped in {:.1f} s\n",
                     suite.count(Verdict::kPassed), suite.count(Verdict::kFailed),
                     suite.count(Verdict::kSkipped), seconds);
}

std::string to_json(const SuiteVerdict& suite) {
  Json json = {{"schema", "cls.test/1"},
               {"version", kVersion},
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
  const std::string totals =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\" time=\"{:.3f}\"",
                  suite.scenarios.size(), suite.count(Verdict::kFailed),
                  suite.count(Verdict::kSkipped), total_seconds(suite));
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites name=\"cls test\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
                      suite.scenarios.size(), suite.count(Verdict::kFailed));
  text += fmt::format("  <testsuite name=\"cls test\" {}>\n", totals);
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    const Scenario& scenario = *verdict.scenario;
    text +=
        fmt::format("    <testcase classname=\"scenarios\" name=\"{}\" file=\"{}\" time=\"{:.3f}\"",
                    xml_escaped(scenario.name), xml_escaped(scenario.file), verdict.seconds);
    if (verdict.verdict == Verdict::kPassed) {
      text += "/>\n";
      continue;
    }
    text += ">\n";
    if (verdict.verdict == Verdict::kSkipped) {
      text += fmt::format("      <skipped message=\"{}\"/>\n", xml_escaped(verdict.reason));
    } else {
      const std::string lines = failures(verdict);
      text += fmt::format("      <failure type=\"check\" message=\"{}\">{}again: {}\n</failure>\n",
                          xml_escaped(lines.substr(0, lines.find('\n'))), xml_escaped(lines),
                          xml_escaped(verdict.repeat));
    }
    text += "    </testcase>\n";
  }
  return text + "  </testsuite>\n</testsuites>\n";
}

std::string to_annotations(const SuiteVerdict& suite) {
  std::string text;
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    if (verdict.verdict != Verdict::kFailed) continue;
    const Scenario& scenario = *verdict.scenario;
    const auto add = [&](int line, const std::string& what) {
      text += fmt::format("::error file={},line={},title={}::{}\n", annotation(scenario.file, true),
                          line, annotation("scenario " + scenario.name, true),
                          annotation(what + "\nagain: " + verdict.repeat, false));
    };
    for (const CheckVerdict& check : verdict.checks) {
      if (!check.passed) add(check.line, describe(check));
    }
    if (!verdict.reason.empty()) add(1, verdict.reason);
  }
  return text;
}

}  // namespace cls::orchestration
