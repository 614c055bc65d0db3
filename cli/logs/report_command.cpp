// `cls report WHAT`: a match as a report with charts.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/percent_encoding.h"
#include "cli/logs/analyzed_match.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"
#include "match/result/recorded_end.h"
#include "viewer/charts/drawing.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_decisions.h"
#include "viewer/page/page_drawings.h"
#include "viewer/report/report_documents.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using match::MatchResult;
using match::PlayerResult;
using match::RpcLatency;
using match::TeamResult;

constexpr const char* kReportDescription =
    "write the report of a match\n"
    "Charts (expected goals, shots, possession, passes, positions, goals), statistics\n"
    "of teams and players, latencies of the Playmakers, and the match to watch.\n"
    "\n"
    "  cls report runs/match-1                          one HTML file: report.html\n"
    "  cls report game.rcg.gz --out game.html           any game log\n"
    "  cls report game.rcg --format md --out report.md  Markdown and SVG, for READMEs\n"
    "  cls report game.rcg --format svg --out charts    the charts alone\n"
    "\n"
    "WHAT is as for 'cls watch': a game log, a page, a match folder, ...";

struct ReportArguments {
  std::string what;
  std::string format;  ///< empty: by the ending of `out`, else html
  std::string out;
  bool without_replay = false;
  bool json = false;
};

void add_replies(const TeamResult& team, std::vector<viewer::PlaymakerReplies>& rows) {
  const auto sums = match::reply_summary(team);
  if (sums.decisions == 0) return;
  rows.push_back({team.name, team.endpoint, sums.decisions, sums.late, sums.missed, sums.rpc_us.p50,
                  sums.rpc_us.p95, sums.rpc_us.p99, sums.rpc_us.max});
}

// Files that `cls match` wrote next to the log, if it is the log of that match.
void add_result(const fs::path& log, viewer::MatchReport& report) {
  namespace match = match;
  if (!match::recorded_end(log.string())) return;
  const auto text = base::read_file(log.parent_path() / match::kResultFile);
  const auto result = match::parse_match_result(text.value_or(""));
  if (!result) return;

  add_replies(result->left, report.playmakers);
  add_replies(result->right, report.playmakers);
  report.warnings = result->warnings;
  if (!result->message.empty()) report.warnings.insert(report.warnings.begin(), result->message);

  const auto manifest = base::Json::parse_or_discarded(
      base::read_file(log.parent_path() / match::kManifestFile).value_or(""));
  if (!manifest.is_object()) return;

  const auto command = manifest.find("command");
  if (command != nullptr && command->is_string()) {
    report.command = command->get<std::string>();
  }
}

struct File {
  fs::path path;
  std::string text;
};

std::vector<File> chart_files(const fs::path& folder, const std::vector<viewer::Chart>& charts) {
  std::vector<File> files;
  for (const viewer::Chart& chart : charts) {
    files.push_back({folder / (chart.name + ".svg"), viewer::standalone_svg(chart.svg)});
  }
  return files;
}

std::string html_text(const ReportArguments& arguments, const AnalyzedMatch& match,
                      const viewer::MatchReport& report, const std::vector<viewer::Chart>& charts) {
  std::string replay;
  if (!arguments.without_replay) {
    replay = viewer::match_page(
        match.match.record, match.text_log(), match.summary.file,
        {.settings = {.missed = viewer::read_missed_decisions(match.found.folder),
                      .drawings = viewer::read_page_drawings(match.found.folder)},
         .compact = match.match.form.compact});
  }
  return viewer::report_html(report, charts, replay);
}

// The file that --out names, or its default.
fs::path target_of(const ReportArguments& arguments, const FoundLog& found) {
  if (!arguments.out.empty()) return arguments.out;
  const std::string prefix = found.name == "match" ? "" : found.name + "-";
  if (arguments.format == "svg") return found.folder / (prefix + "charts");
  return found.folder / (prefix + "report." + arguments.format);
}

std::vector<File> files_of(const ReportArguments& arguments, const AnalyzedMatch& match,
                           const fs::path& target) {
  const std::vector<viewer::Chart> charts = viewer::match_charts(match.summary, match.statistics);
  if (arguments.format == "svg") return chart_files(target, charts);

  viewer::MatchReport report;
  report.summary = match.summary;
  report.statistics = &match.statistics;
  add_result(match.found.logs.game, report);
  if (arguments.format == "html") return {{target, html_text(arguments, match, report, charts)}};

  const std::string folder = target.stem().string() + "-charts";
  std::vector<File> files = chart_files(target.parent_path() / folder, charts);
  files.insert(files.begin(),
               {target, viewer::report_markdown(report, charts, base::percent_encoded(folder))});
  return files;
}

int write_files(const std::vector<File>& files, const std::string& out_option) {
  for (const File& file : files) {
    const fs::path folder = file.path.parent_path();
    if (!folder.empty()) {
      TRY_OR(kCannotCreate, base::create_folders(folder));
    }

    TRY_OR(kCannotCreate, write_beside(file.path, file.text, out_option));
  }
  return kOk;
}

void print_document(const std::vector<File>& files, const AnalyzedMatch& match) {
  base::Json document = {{"schema", "cls.report/1"},
                         {"files", base::Json::array()},
                         {"errors", match.match.record.errors.count}};
  for (const File& file : files) document["files"].push_back(file.path.string());
  print_json(document);
}

// Chooses the format. Returns an exit code.
int choose_format(ReportArguments& arguments) {
  const std::string_view ending = format_of_ending(arguments.out);
  if (arguments.format.empty()) arguments.format = ending.empty() ? "html" : ending;
  if (arguments.format != "html" && arguments.format != "md" && arguments.format != "svg") {
    return print_error(kUsage, "--format '{}': must be html, md or svg", arguments.format);
  }
  if (arguments.format == "svg" && ending == "svg") {
    return print_error(kUsage, "--out '{}': the charts are a folder; name it without .svg",
                       arguments.out);
  }
  const std::string wrong = wrong_ending(arguments.out, arguments.format);
  return wrong.empty() ? kOk : print_error(kUsage, wrong);
}

int run_report_command(const ReportArguments& given) {
  ReportArguments arguments = given;
  TRY_STEP(choose_format(arguments));

  AnalyzedMatch match;
  TRY_STEP(read_match(arguments.what, match));
  const fs::path target = target_of(arguments, match.found);

  if (arguments.format == "html") {
    if (const auto why = why_no_page(target)) return print_error(kCannotCreate, *why);
  }

  const std::vector<File> files = files_of(arguments, match, target);
  TRY_STEP(write_files(files, arguments.out));

  if (arguments.json) {
    print_document(files, match);
  } else {
    fmt::print("{}\n", target.string());
  }

  return match.match.record.errors.empty() ? kOk : kBadData;
}

}  // namespace

void add_report_command(Command& app) {
  auto [command, arguments] = app.command("report", kReportDescription, run_report_command);
  command.group = kResultCommands;
  command.option("WHAT", arguments.what, "game log, page or match folder").required();
  command
      .option("--format FORMAT", arguments.format,
              "html, md (Markdown and a folder of charts) or svg (the folder alone)\n"
              "(default: by the ending of --out, else html)")
      .of_group(kOutputGroup);

  command
      .option("--out FILE", arguments.out,
              "file to write, for svg the folder (default: beside the log)")
      .of_group(kOutputGroup);
  command.flag("--no-replay", arguments.without_replay,
               "HTML: without the match to watch, about 1.5 MB less");

  command.flag("--json", arguments.json, "print the written files as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
