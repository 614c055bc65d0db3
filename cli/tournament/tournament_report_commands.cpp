// `cls tournament plan|status|report|stop|pause|resume`: commands that play no match.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/printable.h"
#include "base/text/suggestion.h"
#include "cli/logs/find_log.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/log_progress.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tournament_options.h"
#include "cli/tournament/tournament_session.h"
#include "league/schedule/schedule.h"
#include "tournament/config/config_file.h"
#include "tournament/config/config_keys.h"
#include "tournament/config/start_times.h"
#include "tournament/report/report_document.h"
#include "tournament/report/report_html.h"
#include "tournament/report/report_text.h"
#include "tournament/slots/timetable.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"
#include "tournament/store/pauses_file.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_decisions.h"
#include "viewer/page/page_drawings.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kPlanDescription =
    "list the fixtures of a tournament\n"
    "\n"
    "  cls tournament plan cup                        of cup/cls.toml\n"
    "  cls tournament plan cup --rounds 10 --json     as run would play them";

constexpr const char* kTournamentStatusDescription =
    "show progress and standings of a tournament\n"
    "\n"
    "  cls tournament status cup           also while it runs\n"
    "  cls tournament status cup --json    the counts";

constexpr const char* kTournamentReportDescription =
    "print tables, statistics and failures of a tournament\n"
    "\n"
    "  cls tournament report cup                                   on the terminal\n"
    "  cls tournament report cup --format html --out report.html   a page to share\n"
    "  cls tournament report cup --json                            for scripts";

constexpr const char* kStopDescription =
    "stop a run gracefully: the current matches are played to the end\n"
    "\n"
    "  cls tournament stop cup    `cls tournament run cup` resumes";

constexpr const char* kPauseDescription =
    "begin a technical time-out: no further match starts\n"
    "\n"
    "  cls tournament pause cup --reason 'network of team BLUE'\n"
    "  cls tournament resume cup\n"
    "\n"
    "Running matches are played to the end. The report lists the time-outs.";

constexpr const char* kResumeDescription =
    "end a technical time-out: matches start again\n"
    "\n"
    "  cls tournament resume cup";

struct PlanArguments {
  TournamentOptions tournament;
  bool json = false;
};

// Prints incrementally: a plan may have a million matches.
void print_plan(const TournamentConfig& config, const std::vector<ScheduledMatch>& matches,
                const Timetable& times) {
  fmt::print("{{\"schema\": \"cls.tournament/1\", \"matches\": [");
  const char* separator = "\n";
  for (const ScheduledMatch& match : matches) {
    fmt::print("{}{}", separator, base::json_line(json_of(config, match)));
    separator = ",\n";
  }
  fmt::print("\n], \"schedule\": {}, \"standings\": []}}\n", base::json_line(json_of(times)));
}

// "2027-07-15 09:00, server 1  " before a line of the plan; a result in place of the server.
std::string when_text(const TournamentConfig& config, const ScheduledMatch& match,
                      const PlannedStart* start) {
  if (start != nullptr) {
    return fmt::format("{}, server {:<3}", local_time_text(start->time), start->server);
  }
  if (!match.outcome) return "";
  const std::time_t began = parse_utc_time(match.outcome->started);
  return fmt::format("{}, {:<10}", began == 0 ? "played" : local_time_text(began),
                     score_text(config, match));
}

// The matches of the plan: those of a tournament that has begun, and those that follow now.
base::Result<std::vector<ScheduledMatch>> planned_matches(const TournamentOptions& options,
                                                          const TournamentConfig& config) {
  std::vector<ScheduledMatch> matches;
  if (holds_plan(options.folder)) {
    const auto plan = read_plan(options.folder);
    if (plan && first_difference(config, *plan).empty()) {
      TRY_INIT(auto state, read_tournament(options.folder));
      matches = std::move(state.matches);
    }
  }
  if (!all_have_outcomes(matches)) return matches;
  for (Fixture& fixture : next_fixtures(config.competition, matches)) {
    matches.push_back(planned(std::move(fixture)));
  }
  return matches;
}

// Teams that are equal where a table decides who goes on: what has separated them.
void print_equal_teams(const Competition& competition, const std::vector<ScheduledMatch>& matches) {
  for (const EqualTeams& equal : equal_teams(competition, matches)) {
    fmt::print(
        "{}: {} are equal; their order is {}\n", equal.table, team_list(competition, equal.teams),
        equal.decided ? "a decision" : "a lot from the seed (cls tournament decide --order)");
  }
}

int run_plan(const PlanArguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  const TournamentConfig& config = chosen.config;

  TRY_INIT_OR(kBadData, const auto matches, planned_matches(arguments.tournament, config));
  const Timetable times = timetable(config, matches, std::time(nullptr));
  if (arguments.json) {
    print_plan(config, matches, times);
    return kOk;
  }

  for (const ScheduledMatch& match : matches) {
    const PlannedStart* start = find_start(times, match.fixture.index);
    fmt::print("{}{}\n", times.starts.empty() ? "" : when_text(config, match, start),
               schedule_text(config, match.fixture));
  }
  const Competition& competition = config.competition;
  const FormatRules& rules = rules_of(competition);
  fmt::print("{}, {} teams, seed {}: {} matches{}\n", rules.name, competition.teams.size(),
             competition.seed, matches.size(), rules.later ? ", more follow from results" : "");
  print_equal_teams(competition, matches);
  if (!times.starts.empty()) {
    fmt::print("{}, a match every {} minutes on each\n", base::counted(times.servers, "server"),
               times.slot_minutes);
  }
  return kOk;
}

struct FolderArguments {
  std::string folder;
  std::string format;  ///< empty: by the ending of `file`, else text
  std::string file;
  std::string columns;
  bool all_matches = false;
  bool replays = false;
  bool json = false;
  std::string reason;
};

// Reads the tournament in DIR. Returns an exit code.
int read(const std::string& folder, TournamentState& state) {
  TRY_STEP(check_tournament(folder, kRunCreatesOne));
  TRY_INIT_OR(kBadData, auto read, read_tournament(folder));
  state = std::move(read);
  return kOk;
}

// The presentation as cls.toml in the folder has it now, and --columns.
int choose_presentation(const FolderArguments& arguments, TournamentConfig& config) {
  std::error_code code;
  const fs::path file = fs::path(arguments.folder) / kConfigFile;
  if (fs::is_regular_file(file, code)) {
    if (ParsedConfig now = read_config(file); now.errors.empty()) {
      config.report = std::move(now.config.report);
    }
  }

  if (arguments.columns.empty()) return kOk;
  const ConfigKey& key = *find_key("columns");
  const auto parsed = key.parse(config, key.read(arguments.columns));
  return parsed ? kOk : print_error(kUsage, "--columns: " + parsed.error().message);
}

// Reads the tournament in DIR with the presentation that the user wants. Returns an exit code.
int read_to_report(const FolderArguments& arguments, TournamentState& state) {
  TRY_STEP(read(arguments.folder, state));
  return choose_presentation(arguments, state.config);
}

TextOptions text_options(const FolderArguments& arguments) {
  return {stdout_width(), arguments.all_matches};
}

int run_status(const FolderArguments& arguments) {
  TournamentState state;
  TRY_STEP(read_to_report(arguments, state));
  const Report report = make_report(state.config, state.matches, arguments.folder);
  const MatchCounts& counts = report.counts;

  if (arguments.json) {
    return print_json({{"schema", "cls.status/1"},
                       {"complete", report.complete},
                       {"scheduled", counts.scheduled},
                       {"finished", counts.finished},
                       {"forfeits", counts.forfeits},
                       {"invalid", counts.invalid},
                       {"annulled", counts.annulled},
                       {"open", counts.open},
                       {"running", state.running},
                       {"paused", state.paused}});
  }

  fmt::print("{}; {}\n", counts_text(counts),
             report.complete ? "complete" : fmt::format("{} running", state.running.size()));
  if (state.paused) fmt::print("paused: {}\n", base::printable(report.pauses.back().reason));
  for (const int index : state.running) {
    const Fixture& fixture = state.matches[static_cast<std::size_t>(index) - 1].fixture;
    fmt::print("{}\n", schedule_text(state.config, fixture));
  }

  fmt::print("\n{}", standings_text(report, text_options(arguments)));
  return kOk;
}

struct ReportFormat {
  std::string_view name;
  std::string (*write)(const Report&, const TextOptions&);
};

template <std::string (*write)(const Report&)>
std::string without_options(const Report& report, const TextOptions& /*options*/) {
  return write(report);
}

constexpr std::array<ReportFormat, 6> kFormats = {{{"text", report_text},
                                                   {"md", without_options<report_markdown>},
                                                   {"csv", without_options<report_csv>},
                                                   {"json", without_options<report_json>},
                                                   {"junit", without_options<report_junit>},
                                                   {"html", without_options<report_html>}}};

// The path of the tournament as links in FILE need it.
fs::path link_base(const FolderArguments& arguments) {
  if (arguments.file.empty()) return arguments.folder;
  std::error_code code;
  const fs::path from = fs::absolute(arguments.file, code).parent_path();
  return fs::weakly_canonical(arguments.folder, code)
      .lexically_relative(fs::weakly_canonical(from, code));
}

// Writes the replay page of a match folder. False without a game log.
bool write_replay(const fs::path& folder) {
  const auto found = find_log(folder.string());
  if (!found) return false;
  const auto match = viewer::read_log_or_page(found->logs.game);
  if (!match || match->record.frames() == 0) return false;

  const auto text = read_text_log(*found);
  const std::string page = viewer::match_page(
      match->record, text ? &*text : nullptr, fs::path(found->logs.game).filename().string(),
      {.settings = {.missed = viewer::read_missed_decisions(folder),
                    .drawings = viewer::read_page_drawings(folder)}});
  return bool(base::write_file(folder / kReplayPage, page));
}

// The matches that have a replay page. With `write`, missing ones are written.
std::set<int> replay_pages(const Report& report, bool write) {
  std::set<int> found;
  LogProgress progress(write ? report.matches.size() : 0);
  std::size_t done = 0;
  for (const ScheduledMatch& match : report.matches) {
    if (write) progress.update(++done);
    if (!match.outcome || match.outcome->folder.empty()) continue;
    const fs::path folder = report.folder / match.outcome->folder;
    std::error_code code;
    const bool exists = fs::exists(folder / kReplayPage, code);
    if (exists || (write && write_replay(folder))) found.insert(match.fixture.index);
  }

  return found;
}

int unknown_format(const std::string& format) {
  std::vector<std::string_view> names;
  for (const ReportFormat& known : kFormats) names.push_back(known.name);
  const std::string_view near = base::nearest_name(format, names);
  return print_error(
      kUsage, near.empty()
                  ? fmt::format("--format '{}': must be one of {}", format, fmt::join(names, ", "))
                  : fmt::format("--format '{}': did you mean '{}'?", format, near));
}

std::string format_of(const FolderArguments& arguments) {
  if (arguments.json) return "json";
  if (!arguments.format.empty()) return arguments.format;
  const std::string_view ending = format_of_ending(arguments.file);
  return std::string(ending.empty() ? "text" : ending);
}

int run_report(const FolderArguments& arguments) {
  const std::string format = format_of(arguments);
  const std::string wrong = arguments.file.empty() ? "" : wrong_ending(arguments.file, format);
  if (!wrong.empty()) return print_error(kUsage, wrong);
  const auto chosen = std::ranges::find(kFormats, format, &ReportFormat::name);
  if (chosen == kFormats.end()) return unknown_format(format);
  TournamentState state;
  TRY_STEP(read_to_report(arguments, state));

  Report report = make_report(state.config, state.matches, arguments.folder);
  report.link_base = link_base(arguments);
  report.replays = replay_pages(report, arguments.replays);
  const std::string text = chosen->write(report, text_options(arguments));

  if (arguments.file.empty()) {
    fmt::print("{}", text);
    return kOk;
  }
  const auto written = base::write_file(arguments.file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

// `was_running`: a run was in progress and stops now.
void print_stop(const FolderArguments& arguments, bool was_running) {
  if (arguments.json) {
    const base::Json document = {
        {"schema", "cls.stop/1"}, {"dir", arguments.folder}, {"was_running", was_running}};
    print_json(document);
    return;
  }
  fmt::print("{}: {}\n", arguments.folder,
             was_running ? "stopping after the current matches" : "no run in progress");
}

int run_stop(const FolderArguments& arguments) {
  TRY_STEP(check_tournament(arguments.folder));

  if (!FolderLock::is_held(arguments.folder)) {
    print_stop(arguments, false);
    return kOk;
  }

  const fs::path file = fs::path(arguments.folder) / kStopFile;
  if (!std::ofstream(file, std::ios::app)) {
    return print_error(kCannotCreate, "{}: cannot create", file.string());
  }

  print_stop(arguments, true);
  return kOk;
}

// The output of `pause` and `resume`; `changed`: the tournament was not so before.
int print_pause(const FolderArguments& arguments, bool paused, const base::Result<bool>& changed) {
  if (!changed) return print_error(kWriteFailed, changed.error().message);
  if (arguments.json) {
    const base::Json document = {{"schema", "cls.pause/1"},
                                 {"dir", arguments.folder},
                                 {"paused", paused},
                                 {"changed", *changed}};
    return print_json(document);
  }
  const char* after = paused ? "paused; running matches are played to the end" : "resumed";
  const char* before = paused ? "is paused already" : "is not paused";
  fmt::print("{}: {}\n", arguments.folder, *changed ? after : before);
  return kOk;
}

int run_pause(const FolderArguments& arguments) {
  TRY_STEP(check_tournament(arguments.folder));
  if (arguments.reason.empty()) {
    return print_error(kUsage, "--reason WHY is required: the report shows it");
  }
  return print_pause(arguments, true, begin_pause(arguments.folder, arguments.reason));
}

int run_resume(const FolderArguments& arguments) {
  TRY_STEP(check_tournament(arguments.folder));
  return print_pause(arguments, false, end_pause(arguments.folder));
}

AddedCommand<FolderArguments> add_folder_command(Command& app, const char* name,
                                                 const char* description,
                                                 int (*run)(const FolderArguments&)) {
  auto added = app.command(name, description, run);
  added.command.option("DIR", added.arguments.folder, "folder of the tournament").required();
  return added;
}

void add_columns_option(Command& command, FolderArguments& arguments) {
  command
      .option("--columns A,B,...", arguments.columns,
              fmt::format("columns of the standings, A,B,...: {} (default: columns in "
                          "cls.toml, else as the format needs)",
                          fmt::join(kStandingsColumns, ", ")))
      .of_group(kOutputGroup);
}

}  // namespace

void add_tournament_plan_command(Command& app) {
  auto [command, arguments] = app.command("plan", kPlanDescription, run_plan);
  add_tournament_options(command, arguments.tournament);
  command.flag("--json", arguments.json, "print the list as JSON").of_group(kOutputGroup);
}

void add_tournament_status_command(Command& app) {
  auto [command, arguments] =
      add_folder_command(app, "status", kTournamentStatusDescription, run_status);
  command.flag("--json", arguments.json, "print the counts as JSON").of_group(kOutputGroup);
  add_columns_option(command, arguments);
}

void add_tournament_report_command(Command& app) {
  auto [command, arguments] =
      add_folder_command(app, "report", kTournamentReportDescription, run_report);
  command
      .option("--format FORMAT", arguments.format,
              "text, md, csv, json, junit or html (default: by the ending of --out, else\n"
              "text)")
      .of_group(kOutputGroup);
  command.option("--out FILE", arguments.file, "write to FILE (default: stdout)")
      .of_group(kOutputGroup);
  command.flag("--json", arguments.json, "the same as --format json").of_group(kOutputGroup);

  command.flag("--matches", arguments.all_matches,
               "text: list all matches with their logs and commands");
  command.flag("--replays", arguments.replays,
               "write a replay page into each match folder (1.5 MB each), to which the\n"
               "lists of matches in Markdown and HTML link");
  add_columns_option(command, arguments);
}

void add_tournament_stop_command(Command& app) {
  auto [command, arguments] = add_folder_command(app, "stop", kStopDescription, run_stop);
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

void add_tournament_pause_command(Command& app) {
  auto [command, arguments] = add_folder_command(app, "pause", kPauseDescription, run_pause);
  command.option("--reason", arguments.reason, "why, for the report").placeholder("WHY").required();
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

void add_tournament_resume_command(Command& app) {
  auto [command, arguments] = add_folder_command(app, "resume", kResumeDescription, run_resume);
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
