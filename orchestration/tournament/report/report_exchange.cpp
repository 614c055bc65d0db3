// CSV and JUnit.
#include <fmt/format.h>

#include <iterator>

#include "base/report/junit.h"
#include "base/text/csv_cell.h"
#include "orchestration/tournament/report/report_document.h"

namespace cls::orchestration::tournament {
namespace {

using base::csv_cell;

std::string number_or_empty(const std::optional<int>& number) {
  return number ? fmt::to_string(*number) : "";
}

base::JunitCase junit_case(const Report& report, const ScheduledMatch& match) {
  const Fixture& fixture = match.fixture;
  base::JunitCase one;
  one.group = fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage;
  one.name = fmt::format("{} {} - {}", fixture.index, report.team(fixture.left),
                         report.team(fixture.right));
  if (!match.outcome) {
    one.result = base::JunitCase::Result::kSkipped;
    one.message = "not played";
    return one;
  }
  const Outcome& outcome = *match.outcome;
  one.seconds = outcome.wall_seconds;
  if (outcome.played()) {
    one.text = score_text(match);
    return one;
  }
  one.result = outcome.fault ? base::JunitCase::Result::kFailed : base::JunitCase::Result::kError;
  one.type = outcome.end_reason;
  one.message = outcome.message;
  one.text = "again: " + rerun_line(*report.config, fixture);
  return one;
}

}  // namespace

std::string report_csv(const Report& report) {
  std::string text =
      "index,round,stage,pairing,left,right,seed,end_reason,forfeit,left_score,right_score,"
      "left_penalties,right_penalties,cycles,wall_seconds,cycles_per_second,left_missed,"
      "right_missed,attempts,host,started,ended,folder,message\n";
  auto out = std::back_inserter(text);
  for (const ScheduledMatch& match : report.matches) {
    const Fixture& fixture = match.fixture;
    fmt::format_to(out, "{},{},{},{},{},{},{},", fixture.index, fixture.round,
                   csv_cell(fixture.stage), fixture.pairing, report.team(fixture.left),
                   report.team(fixture.right), fixture.seed);
    if (!match.outcome) {
      text += ",,,,,,,,,,,,,,,,\n";
      continue;
    }
    const Outcome& outcome = *match.outcome;
    fmt::format_to(out, "{},{},{},{},{},{},{},{:.3f},{:.1f},{},{},{},{},{},{},{},{}\n",
                   outcome.end_reason, outcome.forfeit ? 1 : 0, outcome.left_score,
                   outcome.right_score, number_or_empty(outcome.left_penalties),
                   number_or_empty(outcome.right_penalties), outcome.cycles, outcome.wall_seconds,
                   outcome.cycles_per_second, outcome.left.missed, outcome.right.missed,
                   outcome.attempts, csv_cell(outcome.host), outcome.started, outcome.ended,
                   csv_cell(outcome.folder), csv_cell(outcome.message));
  }
  return text;
}

std::string report_junit(const Report& report) {
  std::vector<base::JunitCase> cases;
  for (const ScheduledMatch& match : report.matches) cases.push_back(junit_case(report, match));
  return base::junit("cls tournament", cases);
}

}  // namespace cls::orchestration::tournament
