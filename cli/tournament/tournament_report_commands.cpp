// `cls tournament plan|status|report|stop`: commands that play no match.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/suggestion.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "cli/tournament/tournament_options.h"
#include "orchestration/tournament/report/report_document.h"
#include "orchestration/tournament/report/report_text.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_document.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;

struct PlanArguments {
  TournamentOptions tournament;
  bool json = false;
};

// Prints incrementally: a plan may have a million matches.
void print_json(const TournamentConfig& config, const std::vector<Fixture>& fixtures) {
  fmt::print("{{\"schema\": \"cls.tournament/1\", \"matches\": [");
  const char* separator = "\n";
  for (const Fixture& fixture : fixtures) {
    fmt::print("{}{}", separator, json_of(config, planned(fixture)).dump());
    separator = ",\n";
  }
  fmt::print("\n], \"standings\": []}}\n");
}

int plan(const PlanArguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  const TournamentConfig& config = chosen.config;
  const std::vector<Fixture> fixtures = next_fixtures(config, {});
  if (arguments.json) {
    print_json(config, fixtures);
    return kOk;
  }
  for (const Fixture& fixture : fixtures) fmt::print("{}\n", schedule_text(config, fixture));
  const bool later = config.format == Format::kGroups || config.format == Format::kKnockout ||
                     config.format == Format::kDoubleElimination || config.format == Format::kSwiss;
  fmt::print("{}, {} teams, seed {}: {} matches{}\n", name(config.format), config.teams.size(),
             config.seed, fixtures.size(), later ? ", more follow from results" : "");
  return kOk;
}

struct FolderArguments {
  std::string folder;
  std::string format = "text";
  std::string file;
  bool json = false;
};

// Reads the tournament in DIR. Returns an exit code.
int read(const std::string& folder, TournamentState& state) {
  if (!holds_plan(folder)) {
    return print_error(kNoInput,
                       fmt::format("{}: no tournament; `cls tournament run` creates one", folder));
  }
  auto read = read_tournament(folder);
  if (!read) return print_error(kBadData, read.error().message);
  state = *std::move(read);
  return kOk;
}

int status(const FolderArguments& arguments) {
  TournamentState state;
  if (const int exit_code = read(arguments.folder, state); exit_code != kOk) return exit_code;
  const Report report = make_report(state.config, state.matches, arguments.folder);
  const MatchCounts& counts = report.counts;
  if (arguments.json) {
    const nlohmann::ordered_json document = {
        {"schema", "cls.status/1"},      {"complete", report.complete},
        {"scheduled", counts.scheduled}, {"finished", counts.finished},
        {"forfeits", counts.forfeits},   {"invalid", counts.invalid},
        {"open", counts.open},           {"running", state.running}};
    fmt::print("{}\n", document.dump(2));
    return kOk;
  }
  fmt::print("{}; {}\n", counts_text(counts),
             report.complete ? "complete" : fmt::format("{} running", state.running.size()));
  for (const int index : state.running) {
    const Fixture& fixture = state.matches[static_cast<std::size_t>(index) - 1].fixture;
    fmt::print("{}\n", schedule_text(state.config, fixture));
  }
  fmt::print("\n{}", standings_text(report));
  return kOk;
}

struct ReportFormat {
  std::string_view name;
  std::string (*write)(const Report&);
};

constexpr std::array<ReportFormat, 6> kFormats = {{{"text", report_text},
                                                   {"md", report_markdown},
                                                   {"csv", report_csv},
                                                   {"json", report_json},
                                                   {"junit", report_junit},
                                                   {"html", report_html}}};

int unknown_format(const std::string& format) {
  std::vector<std::string_view> names;
  for (const ReportFormat& known : kFormats) names.push_back(known.name);
  const std::string_view near = base::nearest_name(format, names);
  return print_error(
      kUsage, near.empty()
                  ? fmt::format("--format '{}': must be one of {}", format, fmt::join(names, ", "))
                  : fmt::format("--format '{}': did you mean '{}'?", format, near));
}

int report(const FolderArguments& arguments) {
  const std::string format = arguments.json ? "json" : arguments.format;
  const auto chosen =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&format](const ReportFormat& known) { return known.name == format; });
  if (chosen == kFormats.end()) return unknown_format(format);
  TournamentState state;
  if (const int exit_code = read(arguments.folder, state); exit_code != kOk) return exit_code;
  const std::string text =
      chosen->write(make_report(state.config, state.matches, arguments.folder));
  if (arguments.file.empty()) {
    fmt::print("{}", text);
    return kOk;
  }
  const auto written = base::write_file(arguments.file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

int stop(const FolderArguments& arguments) {
  if (!holds_plan(arguments.folder)) {
    return print_error(kNoInput, fmt::format("{}: no tournament", arguments.folder));
  }
  const auto lock = FolderLock::try_lock(arguments.folder);
  if (lock && *lock) {
    fmt::print("{}: no run in progress\n", arguments.folder);
    return kOk;
  }
  const fs::path file = fs::path(arguments.folder) / kStopFile;
  if (!std::ofstream(file)) {
    return print_error(kCannotCreate, fmt::format("{}: cannot create", file.string()));
  }
  fmt::print("{}: stopping after the current matches\n", arguments.folder);
  return kOk;
}

std::shared_ptr<FolderArguments> add_folder_command(CLI::App& app, const char* name,
                                                    const char* description,
                                                    int (*run)(const FolderArguments&),
                                                    int& exit_code) {
  const auto arguments = std::make_shared<FolderArguments>();
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("DIR", arguments->folder, "folder of the tournament")->required();
  command->callback([arguments, run, &exit_code] { exit_code = run(*arguments); });
  return arguments;
}

}  // namespace

void add_tournament_plan_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "list the fixtures of a tournament");
  add_tournament_options(*command, arguments->tournament);
  command->add_flag("--json", arguments->json, "print the list as JSON");
  command->callback([arguments, &exit_code] { exit_code = plan(*arguments); });
}

void add_tournament_status_command(CLI::App& app, int& exit_code) {
  const auto arguments = add_folder_command(
      app, "status", "show progress and standings of a tournament", status, exit_code);
  app.get_subcommand("status")->add_flag("--json", arguments->json, "print the counts as JSON");
}

void add_tournament_report_command(CLI::App& app, int& exit_code) {
  const auto arguments = add_folder_command(
      app, "report", "print tables, statistics and failures of a tournament", report, exit_code);
  CLI::App* command = app.get_subcommand("report");
  command->add_option("--format", arguments->format, "text, md, csv, json, junit or html")
      ->capture_default_str();
  command->add_option("--out", arguments->file, "write to FILE (default: stdout)")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "the same as --format json");
}

void add_tournament_stop_command(CLI::App& app, int& exit_code) {
  add_folder_command(app, "stop",
                     "stop a run gracefully: the current matches are played to the end", stop,
                     exit_code);
}

}  // namespace cls::cli
