// `cls tournament plan|status|report|stop`: everything that plays nothing.
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
#include "cli/support/exit_code.h"
#include "cli/tournament/tournament_command.h"
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

// Printed as they are made: a plan may have a million matches.
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
  if (chosen.exit_code != kDone) return chosen.exit_code;
  const TournamentConfig& config = chosen.config;
  const std::vector<Fixture> fixtures = next_fixtures(config, {});
  if (arguments.json) {
    print_json(config, fixtures);
    return kDone;
  }
  for (const Fixture& fixture : fixtures) fmt::print("{}\n", schedule_text(config, fixture));
  const bool later = config.format == Format::kGroups || config.format == Format::kKnockout ||
                     config.format == Format::kDoubleElimination || config.format == Format::kSwiss;
  fmt::print("{}, {} teams, seed {}: {} matches{}\n", name(config.format), config.teams.size(),
             config.seed, fixtures.size(), later ? ", and those that follow from results" : "");
  return kDone;
}

struct LookArguments {
  std::string folder;
  std::string format = "text";
  std::string file;
  bool json = false;
};

// The tournament in DIR, or an exit code.
int read(const std::string& folder, TournamentState& state) {
  if (!holds_plan(folder)) {
    return complain(kNoInput,
                    fmt::format("{} holds no tournament (cls tournament run makes one)", folder));
  }
  auto read = read_tournament(folder);
  if (!read) return complain(kBadData, read.error().message);
  state = *std::move(read);
  return kDone;
}

int status(const LookArguments& arguments) {
  TournamentState state;
  if (const int exit_code = read(arguments.folder, state); exit_code != kDone) return exit_code;
  const Report report = make_report(state.config, state.matches, arguments.folder);
  const MatchCounts& counts = report.counts;
  if (arguments.json) {
    const nlohmann::ordered_json document = {
        {"schema", "cls.status/1"},      {"complete", report.complete},
        {"scheduled", counts.scheduled}, {"finished", counts.finished},
        {"forfeits", counts.forfeits},   {"invalid", counts.invalid},
        {"open", counts.open},           {"running", state.running}};
    fmt::print("{}\n", document.dump(2));
    return kDone;
  }
  fmt::print("{} of {} matches done, {} invalid, {} running{}\n", counts.done(), counts.scheduled,
             counts.invalid, state.running.size(), report.complete ? "; complete" : "");
  for (const int index : state.running) {
    const Fixture& fixture = state.matches[static_cast<std::size_t>(index) - 1].fixture;
    fmt::print("{}\n", schedule_text(state.config, fixture));
  }
  fmt::print("\n{}", standings_text(report));
  return kDone;
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
  return complain(
      kUsage, near.empty()
                  ? fmt::format("--format '{}': must be one of {}", format, fmt::join(names, ", "))
                  : fmt::format("--format '{}': did you mean '{}'?", format, near));
}

int report(const LookArguments& arguments) {
  const std::string format = arguments.json ? "json" : arguments.format;
  const auto chosen =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&format](const ReportFormat& known) { return known.name == format; });
  if (chosen == kFormats.end()) return unknown_format(format);
  TournamentState state;
  if (const int exit_code = read(arguments.folder, state); exit_code != kDone) return exit_code;
  const std::string text =
      chosen->write(make_report(state.config, state.matches, arguments.folder));
  if (arguments.file.empty()) {
    fmt::print("{}", text);
    return kDone;
  }
  const auto written = base::write_file(arguments.file, text);
  return written ? kDone : complain(kCannotCreate, written.error().message);
}

int stop(const LookArguments& arguments) {
  if (!holds_plan(arguments.folder)) {
    return complain(kNoInput, fmt::format("{} holds no tournament", arguments.folder));
  }
  const auto lock = FolderLock::take(arguments.folder);
  if (lock && *lock) {
    fmt::print("nobody plays in {}\n", arguments.folder);
    return kDone;
  }
  const fs::path file = fs::path(arguments.folder) / kStopFile;
  if (!std::ofstream(file)) {
    return complain(kCannotCreate, fmt::format("cannot create {}", file.string()));
  }
  fmt::print("{} ends after the matches under way\n", arguments.folder);
  return kDone;
}

std::shared_ptr<LookArguments> add_look(CLI::App& app, const char* name, const char* description,
                                        int (*run)(const LookArguments&), int& exit_code) {
  const auto arguments = std::make_shared<LookArguments>();
  CLI::App* command = app.add_subcommand(name, description);
  command->add_option("DIR", arguments->folder, "the tournament's folder")->required();
  command->callback([arguments, run, &exit_code] { exit_code = run(*arguments); });
  return arguments;
}

}  // namespace

void add_tournament_plan_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<PlanArguments>();
  CLI::App* command =
      app.add_subcommand("plan", "Lists the matches of a tournament without playing.");
  add_tournament_options(*command, arguments->tournament);
  command->add_flag("--json", arguments->json, "the list as JSON");
  command->callback([arguments, &exit_code] { exit_code = plan(*arguments); });
}

void add_tournament_status_command(CLI::App& app, int& exit_code) {
  const auto arguments =
      add_look(app, "status", "Tells how far a tournament is, and its table.", status, exit_code);
  app.get_subcommand("status")->add_flag("--json", arguments->json, "the counts as JSON");
}

void add_tournament_report_command(CLI::App& app, int& exit_code) {
  const auto arguments = add_look(
      app, "report", "Prints tables, statistics and failures of a tournament.", report, exit_code);
  CLI::App* command = app.get_subcommand("report");
  command->add_option("--format", arguments->format, "text, md, csv, json, junit or html (text)");
  command->add_option("--out", arguments->file, "write it to this file");
  command->add_flag("--json", arguments->json, "the same as --format json");
}

void add_tournament_stop_command(CLI::App& app, int& exit_code) {
  add_look(app, "stop", "Ends a run in order: the matches under way are played to their end.", stop,
           exit_code);
}

}  // namespace cls::cli
