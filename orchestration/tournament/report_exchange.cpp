// CSV and JUnit.
#include <fmt/format.h>

#include <iterator>

#include "gamelog/csv_cell.h"
#include "orchestration/tournament/report_document.h"
#include "orchestration/xml.h"

namespace cls::orchestration {
namespace {

using gamelog::csv_cell;

std::string number_or_empty(const std::optional<int>& number) {
  return number ? fmt::to_string(*number) : "";
}

void add_case(std::string& text, const Report& report, const ScheduledMatch& match) {
  const Fixture& fixture = match.fixture;
  auto out = std::back_inserter(text);
  fmt::format_to(
      out, "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
      xml_escaped(fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage),
      xml_escaped(fmt::format("{} {} - {}", fixture.index, report.team(fixture.left),
                              report.team(fixture.right))),
      match.outcome ? match.outcome->wall_seconds : 0.0);
  if (!match.outcome) {
    text += "      <skipped message=\"not played\"/>\n";
  } else if (!match.outcome->played()) {
    const Outcome& outcome = *match.outcome;
    const char* kind = outcome.fault ? "failure" : "error";
    fmt::format_to(out, "      <{} type=\"{}\" message=\"{}\">{}</{}>\n", kind,
                   xml_escaped(outcome.end_reason), xml_escaped(outcome.message),
                   xml_escaped("again: " + rerun_line(*report.config, fixture)), kind);
  } else {
    fmt::format_to(out, "      <system-out>{}</system-out>\n", xml_escaped(score_text(match)));
  }
  text += "    </testcase>\n";
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
  int failures = 0;
  int errors = 0;
  double seconds = 0.0;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome) continue;
    seconds += match.outcome->wall_seconds;
    if (match.outcome->played()) continue;
    ++(match.outcome->fault ? failures : errors);
  }
  const std::string totals = fmt::format(
      "name=\"cls tournament\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"",
      report.matches.size(), failures, errors, seconds);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format("<testsuites {}>\n  <testsuite {} skipped=\"{}\">\n", totals, totals,
                      report.counts.open);
  for (const ScheduledMatch& match : report.matches) add_case(text, report, match);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace cls::orchestration
