// `cls test`: plays scenarios and reports their verdicts; replays recorded RPCs.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json_document.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "cli/support/ci_reports.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/match_option.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/terminal.h"
#include "match/programs/team_sandbox.h"
#include "match/replay/rpc_replay.h"
#include "proto/rpc.h"
#include "scenario/scenario_library.h"
#include "scenario/suite.h"
#include "scenario/suite_report.h"
#include "soccer/side.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using scenario::Scenario;
using scenario::SuiteOptions;
using scenario::SuiteVerdict;
using scenario::Verdict;

constexpr const char* kDescription =
    "play scenarios and check their expectations\n"
    "\n"
    "  cls test                                  all scenarios shipped with cls\n"
    "  cls test --against localhost:50051        your Playmaker on the tested side\n"
    "  cls test my_tests/ --junit report.xml     your own, for CI (docs/testing.md)\n"
    "  cls test referee_corner_kick --seed 3     one scenario, one seed\n"
    "  cls test --replay FILE localhost:50051    compare replies with a recording\n"
    "  cls test --replay FILE --at 1234 --player 7 localhost:50051";

struct Arguments {
  match::TlsFileNames tls;
  std::vector<std::string> scenarios;
  std::string filter;
  std::string shard;
  int jobs = 0;
  std::optional<std::uint64_t> seed;
  std::string against;
  std::string folder = "runs/test";
  std::string export_folder;
  std::string replay;
  std::string side;
  std::optional<int> at;
  std::optional<int> player;
  bool json = false;
  std::optional<double> start_timeout_s;
  bool list = false;
  bool sandbox = true;
  bool accept_golden = false;
  bool quiet = false;
  bool force = false;
  bool strict = false;
  CiReports reports;
};

/// An error with its exit code.
struct Failure {
  ExitCode code = kUsage;
  std::string message;
};

// A pattern of the shell; one without `*` matches anywhere in the name.
bool matches(const std::string& pattern, const std::string& name) {
  if (pattern.find('*') == std::string::npos) return name.find(pattern) != std::string::npos;
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

std::optional<Failure> add_file(const std::string& name, std::vector<Scenario>& chosen) {
  if (const auto absence = base::absence(name)) {
    return Failure{kNoInput, fmt::format("{}: {}", name, *absence)};
  }

  auto read = scenario::read_scenarios(name, endpoint_of_team);
  if (!read) return Failure{kBadData, read.error().message};
  chosen.insert(chosen.end(), read->begin(), read->end());
  return std::nullopt;
}

// An argument with a slash or ".json" is a file or folder, any other a shipped scenario first.
bool is_path(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json");
}

std::optional<Failure> add_named(const std::string& name, const std::vector<Scenario>& shipped,
                                 std::vector<Scenario>& chosen) {
  std::vector<std::string_view> names;
  for (const Scenario& scenario : shipped) {
    if (scenario.name == name) {
      chosen.push_back(scenario);
      return std::nullopt;
    }
    names.push_back(scenario.name);
  }

  if (!base::absence(name)) return add_file(name, chosen);
  return Failure{kNoInput,
                 fmt::format("unknown scenario '{}'{}", name, base::did_you_mean(name, names))};
}

// Keeps one part: "2/4" is the second of four.
std::optional<Failure> select_shard(const std::string& shard, std::vector<Scenario>& scenarios) {
  const std::vector<std::string_view> parts = base::split(shard, '/');
  const int index = base::parse_int(parts.front()).value_or(0);
  const int count = parts.size() == 2 ? base::parse_int(parts.back()).value_or(0) : 0;
  if (index < 1 || count < index) {
    return Failure{kUsage, fmt::format("--shard '{}': must be K/N, such as 1/4", shard)};
  }

  std::vector<Scenario> selected;
  for (int i = index - 1; i < std::ssize(scenarios); i += count) {
    selected.push_back(scenarios[static_cast<std::size_t>(i)]);
  }
  scenarios = std::move(selected);
  return std::nullopt;
}

// As dev plays them without arguments.
bool in_project_with_scenarios() {
  return !base::why_no_folder("tests") && !base::absence(tournament::kConfigFile);
}

std::optional<Failure> choose(const Arguments& arguments, std::vector<Scenario>& chosen) {
  std::vector<Scenario> shipped;
  if (!std::all_of(arguments.scenarios.begin(), arguments.scenarios.end(), is_path) ||
      arguments.scenarios.empty()) {
    auto read = scenario::shipped_scenarios();
    if (!read) return Failure{kInternalError, read.error().message};
    shipped = *std::move(read);
  }

  if (arguments.scenarios.empty()) {
    chosen = shipped;
    if (!arguments.quiet && in_project_with_scenarios()) {
      fmt::print(stderr,
                 "the scenarios that ship with cls; those of this folder: cls test tests/\n");
    }
  }
  for (const std::string& argument : arguments.scenarios) {
    auto failure =
        is_path(argument) ? add_file(argument, chosen) : add_named(argument, shipped, chosen);
    if (failure) return failure;
  }

  const auto unwanted = [&](const Scenario& scenario) {
    return !matches(arguments.filter, scenario.name);
  };
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), unwanted), chosen.end());
  if (chosen.empty()) {
    return Failure{kUsage, fmt::format("--filter '{}': no scenario matches", arguments.filter)};
  }
  return arguments.shard.empty() ? std::nullopt : select_shard(arguments.shard, chosen);
}

std::optional<double> start_timeout(const Arguments& arguments) {
  return arguments.start_timeout_s ? arguments.start_timeout_s : start_timeout_of_project();
}

std::optional<Failure> resolve(const Arguments& arguments, SuiteOptions& options) {
  options.seed = arguments.seed;
  options.folder = arguments.folder;
  options.sandbox = arguments.sandbox;
  options.start_timeout_s = start_timeout(arguments);
  options.jobs = arguments.jobs;
  if (options.jobs == 0) options.jobs = static_cast<int>(std::thread::hardware_concurrency());
  options.jobs = std::max(options.jobs, 1);

  if (arguments.against.empty()) return std::nullopt;
  const int read =
      read_side("--against: ", arguments.against, arguments.tls, options.against.emplace());
  if (read != kOk) return Failure{static_cast<ExitCode>(read), ""};

  options.against_text = arguments.against;

  // A user's Playmaker need not support parallel matches.
  const bool shared = options.against->kind != match::Endpoint::Kind::kMock;
  if (shared && arguments.jobs == 0) options.jobs = 1;
  return std::nullopt;
}

int list(const std::vector<Scenario>& scenarios, bool json) {
  if (json) {
    nlohmann::ordered_json document = {{"schema", "cls.scenarios/1"},
                                       {"scenarios", nlohmann::ordered_json::array()}};
    for (const Scenario& scenario : scenarios) {
      document["scenarios"].push_back({{"name", scenario.name}, {"about", scenario.about}});
    }
    fmt::print("{}", base::json_document(document));
    return kOk;
  }

  for (const Scenario& scenario : scenarios) {
    fmt::print("{:<32} {}\n", scenario.name, scenario.about);
  }
  return kOk;
}

// Files of the folder that differ from the shipped ones of the same name.
std::vector<fs::path> changed_files(const fs::path& folder) {
  std::vector<fs::path> changed;
  std::error_code code;
  for (const auto& file : scenario::shipped_files()) {
    const fs::path path = folder / file.name;
    if (fs::exists(path, code) && base::read_file(path) != file.text) changed.push_back(path);
  }
  return changed;
}

// Writes copies of the shipped scenarios as templates; edited ones are the user's.
int export_to(const fs::path& folder, bool force, bool json) {
  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }

  const std::vector<fs::path> changed = changed_files(folder);
  if (!changed.empty() && !force) {
    std::vector<std::string> errors;
    for (const fs::path& file : changed) {
      errors.push_back(fmt::format("{}: differs from the shipped scenario", file.string()));
    }
    errors.emplace_back("nothing written; --force renames these files to NAME.old first");
    return print_errors(kCannotCreate, errors);
  }

  for (const fs::path& file : changed) {
    const auto kept = base::set_aside(file);
    if (!kept) return print_error(kCannotCreate, kept.error().message);
    fmt::print(stderr, "cls: {} renamed to {}\n", file.string(), kept->filename().string());
  }

  for (const scenario::ShippedFile& file : scenario::shipped_files()) {
    const auto written = base::write_file(folder / file.name, file.text);
    if (written) continue;
    return print_error(kCannotCreate, written.error().message);
  }

  const std::size_t count = scenario::shipped_files().size();
  if (json) {
    const nlohmann::ordered_json document = {
        {"schema", "cls.export/1"}, {"dir", folder.string()}, {"files", count}};
    fmt::print("{}", base::json_document(document));
  } else {
    fmt::print("{} files in {}\n", count, folder.string());
  }
  return kOk;
}

// True when accepting the golden values removes all failures.
bool only_golden_failed(const SuiteVerdict& suite) {
  for (const auto& verdict : suite.scenarios) {
    if (verdict.verdict == Verdict::kFailed && !verdict.reason.empty()) return false;
    for (std::size_t i = 0; i < verdict.checks.size(); ++i) {
      const auto& checks = verdict.scenario->checks;
      const bool golden =
          i < checks.size() && std::holds_alternative<scenario::GoldenCheck>(checks[i].what);
      if (!verdict.checks[i].passed && !golden) return false;
    }
  }
  return true;
}

int finish(const Arguments& arguments, const SuiteVerdict& suite, double seconds) {
  if (arguments.json) {
    fmt::print("{}", to_json(suite));
  } else {
    fmt::print("{}", summary(suite, seconds, stdout_supports_color()));
  }

  const ExitCode reported = write_ci_reports(
      arguments.reports, {to_junit(suite), to_annotations(suite), to_markdown(suite)});
  if (reported != kOk) return reported;
  if (arguments.accept_golden) {
    const auto changed = accept_golden_values(suite);
    if (!changed) return print_error(kCannotCreate, changed.error().message);
    fmt::print(stderr, "{} golden values changed\n", *changed);
    return only_golden_failed(suite) ? kOk : kFailed;
  }

  if (!suite.passed()) return kFailed;
  const int skipped = suite.count(Verdict::kSkipped);
  if (!arguments.strict || skipped == 0) return kOk;
  return print_error(kFailed, fmt::format("{} skipped (--strict)", skipped));
}

int report_failure(const Failure& failure) {
  if (!failure.message.empty()) print_error(failure.code, failure.message);
  return failure.code;
}

// Options of --replay FILE ENDPOINT.
std::optional<Failure> resolve(const Arguments& arguments, match::ReplayOptions& options) {
  if (arguments.scenarios.size() != 1)
    return Failure{kUsage, "--replay FILE requires one ENDPOINT"};

  const int read =
      read_playmaker("--replay: ", arguments.scenarios.front(), arguments.tls, options.endpoint);
  if (read != kOk) return Failure{static_cast<ExitCode>(read), ""};

  options.file = arguments.replay;
  options.folder = arguments.folder;
  if (const auto limit = start_timeout(arguments)) options.start_timeout_s = *limit;
  if (const auto absence = base::absence(options.file)) {
    return Failure{kNoInput, fmt::format("{}: {}", options.file, *absence)};
  }
  if (options.endpoint.starts_programs()) {
    const auto created = base::create_folders(options.folder);
    if (!created) return Failure{kCannotCreate, created.error().message};
  }

  options.cycle = arguments.at;
  options.agent = arguments.player;

  if (arguments.side.empty()) return std::nullopt;
  options.side = soccer::parse_side(arguments.side);
  if (!options.side) {
    return Failure{kUsage, fmt::format("--side '{}': must be left or right", arguments.side)};
  }
  return std::nullopt;
}

int run_replay(const Arguments& arguments) {
  constexpr std::size_t kShownDifferences = 20;
  match::ReplayOptions options;
  if (const auto failure = resolve(arguments, options)) return report_failure(*failure);

  const std::atomic<int>& signal = watch_interrupts();
  const auto result = replay_recording(options, signal);
  if (!result) {
    const bool about_file = result.error().message.rfind(options.file, 0) == 0;
    return report_failure({about_file ? kBadData : kUnavailable, result.error().message});
  }

  fmt::print("{}", arguments.json ? to_json(*result) : to_text(*result, kShownDifferences));
  if (result->interrupted) return signal_exit_code(signal);
  return result->passed() ? kOk : kFailed;
}

void warn_without_sandbox(const std::vector<Scenario>& scenarios, const SuiteOptions& options) {
  const auto is_external = [](const auto& side) { return !side.playmaker.has_playmaker(); };
  const bool external =
      (options.against && !options.against->has_playmaker()) ||
      std::any_of(scenarios.begin(), scenarios.end(), [&](const Scenario& scenario) {
        return std::any_of(scenario.sides.begin(), scenario.sides.end(), is_external);
      });
  const std::string missing = match::missing_sandbox();
  if (!external || !options.sandbox || missing.empty()) return;
  print_error(kOk, "warning: " + missing);
}

int run_test_command(const Arguments& arguments) {
  if (!arguments.replay.empty()) return run_replay(arguments);
  if (!arguments.side.empty()) return print_error(kUsage, "--side requires --replay");
  if (arguments.at) return print_error(kUsage, "--at requires --replay");
  if (arguments.player) return print_error(kUsage, "--player requires --replay");
  if (!arguments.export_folder.empty()) {
    return export_to(arguments.export_folder, arguments.force, arguments.json);
  }

  std::vector<Scenario> scenarios;
  if (const auto failure = choose(arguments, scenarios)) return report_failure(*failure);
  if (arguments.list) return list(scenarios, arguments.json);
  SuiteOptions options;
  if (const auto failure = resolve(arguments, options)) return report_failure(*failure);
  warn_without_sandbox(scenarios, options);

  const bool color = !arguments.json && stdout_supports_color();
  const auto on_done = [&](const scenario::ScenarioVerdict& verdict) {
    // The summary counts those that an interrupt cut off.
    if (verdict.verdict == Verdict::kInterrupted) return;
    const bool wanted = verdict.verdict == Verdict::kFailed || !arguments.quiet;
    if (!wanted) return;
    fmt::print(arguments.json ? stderr : stdout, "{}", to_text(verdict, color));
    std::fflush(arguments.json ? stderr : stdout);
  };

  const std::atomic<int>& signal = watch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const SuiteVerdict suite = run_suite(scenarios, options, on_done, signal);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const int code = finish(arguments, suite, took.count());
  if (signal.load() != 0) return signal_exit_code(signal);
  return code;
}

}  // namespace

void add_test_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("test", kDescription);
  command.group = kPlayCommands;
  command.starts_programs = true;

  Arguments& a = *arguments;
  command.option("SCENARIO", a.scenarios,
                 "names, files or folders (default: all shipped scenarios)");
  command.option("--against", a.against, "SIDE that plays the side under test");
  command.option("--filter", a.filter,
                 "only names that contain this text or match this pattern (*)");
  command.option("--seed", a.seed, "only this seed");
  command.option("--shard", a.shard, "K/N: play the K-th of N parts");

  command
      .option("--jobs", a.jobs,
              "parallel runs (default: processor cores; 1 with --against your Playmaker)")
      .range(1, 1000);

  add_ci_options(command, a.reports);
  command.flag("--json", a.json, "print only the result document");
  command.option("--dir", a.folder, "folder of failed runs").shows_default();
  command.flag("--accept", a.accept_golden, "accept current values as the new golden values");
  command.flag("--bless", a.accept_golden, "").of_group(kHidden);  // former name of --accept
  command.flag("--list", a.list, "list names and descriptions");
  command.option("--export", a.export_folder, "write the shipped scenarios to a folder");
  command.flag("--force", a.force, "with --export: rename changed files to NAME.old first");

  command.option("--replay", a.replay,
                 "send a recording of `cls match --record-rpc` to the Playmaker ENDPOINT");
  command.option("--side", a.side, "side of the recording for --replay: left or right");
  command.option("--at", a.at, "with --replay: only decisions of this cycle");
  command.option("--player", a.player, "with --replay: only calls of this player")
      .range(1, proto::kTrainerNumber);

  command
      .option("--start-timeout", a.start_timeout_s,
              "seconds until Playmakers answer (default: that of cls.toml, else 20)")
      .above(0);
  add_match_option(command, "sandbox", a.sandbox);
  add_tls_options(command, a.tls);
  command.flag("--strict", a.strict, "fail (exit 1) on any skipped scenario");
  command.flag("--quiet", a.quiet, "print only failures and the summary");
  command.run = [arguments] { return run_test_command(*arguments); };
}

}  // namespace cls::cli
