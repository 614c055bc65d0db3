// Formats verdicts as text, JSON, JUnit, Markdown and GitHub annotations.
#include "scenario/suite_report.h"

#include <fmt/format.h>

#include "base/report/github.h"
#include "base/report/junit.h"
#include "base/system/version.h"
#include "base/text/enum_names.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/table.h"
#include "base/text/wrap_text.h"

namespace cls::scenario {
namespace {

using base::Json;

constexpr auto kVerdictNames =
    base::enum_names<Verdict>("passed", "failed", "skipped", "interrupted");

constexpr std::string_view kDim = "2";
constexpr std::string_view kGreen = "32";
constexpr std::string_view kYellow = "33";
constexpr std::string_view kRed = "1;31";

std::string colored(std::string_view text, std::string_view code, bool color) {
  return color ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

// "tests/corner.json: line 12, seed 3: ...".
std::string place(const Scenario& scenario) {
  return scenario.built_in ? "built-in scenario" : scenario.file;
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

// A line below a verdict.
std::string detail(const std::string& text, std::size_t width) {
  constexpr std::size_t kIndent = 6;
  return fmt::format("{:{}}{}\n", "", kIndent,
                     width == 0 ? text : base::wrap_text(text, width, kIndent));
}

std::string watch_line(const ScenarioVerdict& verdict) {
  return verdict.page.empty() ? "" : fmt::format("watch: {}\n", verdict.page);
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
               {"verdict", kVerdictNames.name(verdict.verdict)},
               {"seeds", verdict.seeds}};
  if (!verdict.reason.empty()) json["reason"] = verdict.reason;
  json["checks"] = Json::array();
  for (const CheckVerdict& check : verdict.checks) json["checks"].push_back(json_of(check));

  if (!verdict.rerun.empty()) {
    json["repeat"] = verdict.rerun;
    json["replay"] = verdict.replay;
    json["page"] = verdict.page.empty() ? Json(nullptr) : Json(verdict.page);
  }

  json["seconds"] = verdict.seconds;
  return json;
}

}  // namespace

std::string to_text(const ScenarioVerdict& verdict, bool color, std::size_t width) {
  const Scenario& scenario = *verdict.scenario;
  const bool not_played =
      verdict.verdict == Verdict::kSkipped || verdict.verdict == Verdict::kInterrupted;
  if (not_played) {
    return fmt::format("{}  {}: {}\n", colored("skip", kYellow, color), scenario.name,
                       verdict.reason);
  }
  const std::string runs =
      verdict.seeds.size() > 1 ? fmt::format("  ({} seeds)", verdict.seeds.size()) : "";
  if (verdict.verdict == Verdict::kPassed) {
    return fmt::format("{}    {}{}\n", colored("ok", kGreen, color), scenario.name,
                       colored(runs, kDim, color && !runs.empty()));
  }

  std::string text = fmt::format("{}{}\n", colored("FAIL  " + scenario.name, kRed, color), runs);
  if (!scenario.about.empty()) text += detail(scenario.about, width);
  for (const CheckVerdict& check : verdict.checks) {
    if (!check.passed) text += detail(place(scenario) + ": " + describe(check), width);
  }

  if (!verdict.reason.empty()) text += detail(verdict.reason, width);
  if (!verdict.replay.empty()) text += fmt::format("      logs: {}\n", verdict.replay);
  if (!verdict.page.empty()) text += fmt::format("      watch: {}\n", verdict.page);
  text += fmt::format("      rerun: {}\n", verdict.rerun);
  if (scenario.built_in) {
    text += fmt::format("      file: cls test --export DIR writes DIR/{}.json\n", scenario.name);
  }

  return text;
}

std::string summary(const SuiteVerdict& suite, double seconds, bool color) {
  const int failed = suite.count(Verdict::kFailed);
  std::string text =
      fmt::format("{} passed, {}, {} skipped in {:.1f} s\n", suite.count(Verdict::kPassed),
                  colored(fmt::format("{} failed", failed), kRed, color && failed > 0),
                  suite.count(Verdict::kSkipped), seconds);
  if (const int interrupted = suite.count(Verdict::kInterrupted); interrupted > 0) {
    text += fmt::format("interrupted: {} of {} scenarios were not played to the end\n", interrupted,
                        suite.scenarios.size());
  }
  return text;
}

std::string to_json(const SuiteVerdict& suite) {
  Json json = {{"schema", "cls.test/1"},
               {"version", base::kVersion},
               {"passed", suite.count(Verdict::kPassed)},
               {"failed", suite.count(Verdict::kFailed)},
               {"skipped", suite.count(Verdict::kSkipped)},
               {"interrupted", suite.count(Verdict::kInterrupted)}};
  json["scenarios"] = Json::array();
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    json["scenarios"].push_back(json_of(verdict));
  }
  return base::json_document(json);
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
    if (verdict.verdict == Verdict::kSkipped || verdict.verdict == Verdict::kInterrupted) {
      one.result = base::JunitCase::Result::kSkipped;
      one.message = verdict.reason;
    } else if (verdict.verdict == Verdict::kFailed) {
      const std::string lines = failures(verdict);
      one.result = base::JunitCase::Result::kFailed;
      one.type = "check";
      one.message = lines.substr(0, lines.find('\n'));
      one.text = fmt::format("{}{}rerun: {}\n", lines, watch_line(verdict), verdict.rerun);
      one.attachment = verdict.page;
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
      text += base::format_github_error(
          {scenario.built_in ? "" : scenario.file, line}, "scenario " + scenario.name,
          fmt::format("{}\n{}rerun: {}", what, watch_line(verdict), verdict.rerun));
    };
    for (const CheckVerdict& check : verdict.checks) {
      if (!check.passed) add(check.line, describe(check));
    }
    if (!verdict.reason.empty()) add(1, verdict.reason);
  }

  return text;
}

std::string to_markdown(const SuiteVerdict& suite) {
  std::string text =
      fmt::format("### cls test: {} passed, {} failed, {} skipped\n", suite.count(Verdict::kPassed),
                  suite.count(Verdict::kFailed), suite.count(Verdict::kSkipped));
  base::Table table;
  table.add_columns({"scenario", "failure", "replay page", "rerun"});
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    if (verdict.verdict != Verdict::kFailed) continue;
    const std::string lines = failures(verdict);
    table.add_row({verdict.scenario->name, lines.substr(0, lines.find('\n')),
                   verdict.page.empty() ? "-" : verdict.page, verdict.rerun});
  }

  return suite.passed() ? text : text + "\n" + table.format_markdown();
}

}  // namespace cls::scenario
