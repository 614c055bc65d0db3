// `cls test`: plays scenarios and reports their verdicts.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "base/system/parallel.h"
#include "base/text/json.h"
#include "base/text/number_text.h"
#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "cli/match/test_arguments.h"
#include "cli/support/interrupt.h"
#include "cli/support/match_option.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "match/programs/team_sandbox.h"
#include "proto/rpc.h"
#include "scenario/scenario_library.h"
#include "scenario/suite.h"
#include "scenario/suite_report.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace {

using scenario::Scenario;
using scenario::SuiteOptions;
using scenario::SuiteVerdict;
using scenario::Verdict;

constexpr const char* kTestDescription =
    "play scenarios and check their expectations\n"
    "\n"
    "  cls test                                  all scenarios shipped with cls\n"
    "  cls test --against localhost:50051        your Playmaker on the tested side\n"
    "  cls test my_tests/ --junit report.xml     your own, for CI (docs/testing.md)\n"
    "  cls test referee_corner_kick --seed 3     one scenario, one seed\n"
    "  cls test --replay FILE localhost:50051    compare replies with a recording\n"
    "  cls test --replay FILE --at 1234 --player 7 localhost:50051";

// A pattern of the shell; one without `*` matches anywhere in the name.
bool fits_pattern(const std::string& pattern, const std::string& name) {
  if (pattern.find('*') == std::string::npos) return name.find(pattern) != std::string::npos;
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

int add_file(const std::string& name, std::vector<Scenario>& chosen) {
  if (const auto absence = base::absence(name)) {
    return print_error(kNoInput, "{}: {}", name, *absence);
  }

  TRY_INIT_OR(kBadData, const auto read, scenario::read_scenarios(name, endpoint_of_team));
  chosen.insert(chosen.end(), read.begin(), read.end());
  return kOk;
}

// An argument with a slash or ".json" is a file or folder, any other a shipped scenario first.
bool is_path(const std::string& name) {
  return name.find('/') != std::string::npos || name.ends_with(".json");
}

int add_named(const std::string& name, const std::vector<Scenario>& shipped,
              std::vector<Scenario>& chosen) {
  const auto found = std::ranges::find(shipped, name, &Scenario::name);
  if (found != shipped.end()) {
    chosen.push_back(*found);
    return kOk;
  }
  if (!base::absence(name)) return add_file(name, chosen);

  std::vector<std::string_view> names;
  for (const Scenario& scenario : shipped) names.push_back(scenario.name);
  return print_error(kNoInput, "unknown scenario '{}'{}", name, base::did_you_mean(name, names));
}

// Keeps one part: "2/4" is the second of four.
int select_shard(const std::string& shard, std::vector<Scenario>& scenarios) {
  const std::vector<std::string_view> parts = base::split(shard, '/');
  const int index = base::parse_int(parts.front()).value_or(0);
  const int count = parts.size() == 2 ? base::parse_int(parts.back()).value_or(0) : 0;
  if (index < 1 || count < index) {
    return print_error(kUsage, "--shard '{}': must be K/N, such as 1/4", shard);
  }

  std::vector<Scenario> selected;
  for (int i = index - 1; i < std::ssize(scenarios); i += count) {
    selected.push_back(scenarios[base::index(i)]);
  }
  scenarios = std::move(selected);
  return kOk;
}

// As dev plays them without arguments.
bool in_project_with_scenarios() {
  return !base::why_no_folder("tests") && !base::absence(tournament::kConfigFile);
}

int choose(const TestArguments& arguments, std::vector<Scenario>& chosen) {
  std::vector<Scenario> shipped;
  if (arguments.scenarios.empty() || !std::ranges::all_of(arguments.scenarios, is_path)) {
    TRY_INIT_OR(kInternalError, shipped, scenario::shipped_scenarios());
  }

  if (arguments.scenarios.empty()) {
    chosen = shipped;
    if (!arguments.quiet && in_project_with_scenarios()) {
      fmt::print(stderr,
                 "the scenarios that ship with cls; those of this folder: cls test tests/\n");
    }
  }
  for (const std::string& argument : arguments.scenarios) {
    TRY_STEP(is_path(argument) ? add_file(argument, chosen) : add_named(argument, shipped, chosen));
  }

  std::erase_if(chosen, [&](const Scenario& scenario) {
    return !fits_pattern(arguments.filter, scenario.name);
  });
  if (chosen.empty()) {
    return print_error(kUsage, "--filter '{}': no scenario matches", arguments.filter);
  }
  return arguments.shard.empty() ? int{kOk} : select_shard(arguments.shard, chosen);
}

int resolve(const TestArguments& arguments, SuiteOptions& options) {
  options.seed = arguments.seed;
  options.folder = arguments.folder;
  if (const auto sandbox = match::parse_sandbox(arguments.sandbox)) options.sandbox = *sandbox;
  options.sandbox_playmakers = arguments.sandbox_playmakers;
  options.start_timeout_s = start_timeout(arguments);
  options.jobs = arguments.jobs;
  if (options.jobs == 0) options.jobs = static_cast<int>(base::default_jobs());

  if (arguments.against.empty()) return kOk;
  TRY_STEP(read_side("--against: ", arguments.against, arguments.tls, options.against.emplace()));
  options.against_text = arguments.against;

  // A user's Playmaker need not support parallel matches.
  const bool shared = options.against->kind != match::Endpoint::Kind::kMock;
  if (shared && arguments.jobs == 0) options.jobs = 1;
  return kOk;
}

int list_scenarios(const std::vector<Scenario>& scenarios, bool json) {
  if (json) {
    base::Json document = {{"schema", "cls.scenarios/1"}, {"scenarios", base::Json::array()}};
    for (const Scenario& scenario : scenarios) {
      document["scenarios"].push_back({{"name", scenario.name}, {"about", scenario.about}});
    }
    return print_json(document);
  }

  for (const Scenario& scenario : scenarios) {
    fmt::print("{:<32} {}\n", scenario.name, scenario.about);
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

int finish_suite(const TestArguments& arguments, const SuiteVerdict& suite, double seconds) {
  if (arguments.json) {
    fmt::print("{}", to_json(suite));
  } else {
    fmt::print("{}", summary(suite, seconds, stdout_supports_color()));
  }

  const ExitCode reported = write_ci_reports(
      arguments.reports, {to_junit(suite), to_annotations(suite), to_markdown(suite)});
  if (reported != kOk) return reported;
  if (arguments.accept_golden) {
    TRY_INIT_OR(kCannotCreate, const auto changed, accept_golden_values(suite));
    fmt::print(stderr, "{} golden values changed\n", changed);
    return only_golden_failed(suite) ? kOk : kFailed;
  }

  if (!suite.passed()) return kFailed;
  const int skipped = suite.count(Verdict::kSkipped);
  if (!arguments.strict || skipped == 0) return kOk;
  return print_error(kFailed, "{} skipped (--strict)", skipped);
}

void warn_without_sandbox(const std::vector<Scenario>& scenarios, const SuiteOptions& options) {
  const auto is_external = [](const auto& side) { return !side.playmaker.has_playmaker(); };
  const bool external = (options.against && !options.against->has_playmaker()) ||
                        std::ranges::any_of(scenarios, [&](const Scenario& scenario) {
                          return std::ranges::any_of(scenario.sides, is_external);
                        });
  match::MatchOptions conditions;
  conditions.sandbox = options.sandbox;
  const std::string missing = match::missing_sandbox(conditions);
  if (!external || missing.empty()) return;
  print_error(kOk, "warning: " + missing);
}

int run_test_command(const TestArguments& arguments) {
  if (!arguments.replay.empty()) return replay_recording(arguments);
  if (!arguments.side.empty()) return print_error(kUsage, "--side requires --replay");
  if (arguments.at) return print_error(kUsage, "--at requires --replay");
  if (arguments.player) return print_error(kUsage, "--player requires --replay");
  if (!arguments.export_folder.empty()) return export_scenarios(arguments);

  std::vector<Scenario> scenarios;
  TRY_STEP(choose(arguments, scenarios));
  if (arguments.list) return list_scenarios(scenarios, arguments.json);
  SuiteOptions options;
  TRY_STEP(resolve(arguments, options));
  warn_without_sandbox(scenarios, options);

  const bool color = !arguments.json && stdout_supports_color();
  const std::size_t width = stdout_is_terminal() && !arguments.json ? stdout_width() : 0;
  const auto on_done = [&](const scenario::ScenarioVerdict& verdict) {
    // The summary counts those that an interrupt cut off.
    if (verdict.verdict == Verdict::kInterrupted) return;
    const bool wanted = verdict.verdict == Verdict::kFailed || !arguments.quiet;
    if (!wanted) return;
    fmt::print(arguments.json ? stderr : stdout, "{}", to_text(verdict, color, width));
    std::fflush(arguments.json ? stderr : stdout);
  };

  const std::atomic<int>& signal = watch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const SuiteVerdict suite = run_suite(scenarios, options, on_done, signal);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const int code = finish_suite(arguments, suite, took.count());
  if (signal.load() != 0) return signal_exit_code(signal);
  return code;
}

}  // namespace

std::optional<double> start_timeout(const TestArguments& arguments) {
  return arguments.start_timeout_s ? arguments.start_timeout_s : start_timeout_of_project();
}

void add_test_command(Command& app) {
  auto [command, arguments] = app.command("test", kTestDescription, run_test_command);
  command.group = kPlayCommands;
  command.starts_programs = true;

  auto& a = arguments;
  command.option("SCENARIO", a.scenarios,
                 "names, files or folders (default: all shipped scenarios)");
  command.option("--against SIDE", a.against, "SIDE that plays the side under test");
  command.option("--filter PATTERN", a.filter,
                 "only names that contain this text or match this pattern (*)");
  command.option("--seed", a.seed, "only this seed");
  command.option("--shard K/N", a.shard, "K/N: play the K-th of N parts");

  command
      .option("--jobs", a.jobs,
              "parallel runs (default: processor cores; 1 with --against your Playmaker)")
      .range(1, 1000);

  add_ci_options(command, a.reports);
  command.flag("--json", a.json, "print only the result document").of_group(kOutputGroup);
  command.setting("--dir DIR", a.folder, "folder of failed runs");
  command.flag("--accept", a.accept_golden, "accept current values as the new golden values");
  command.flag("--bless", a.accept_golden, "").of_group(kHidden);  // former name of --accept
  command.flag("--list", a.list, "list names and descriptions");
  command.option("--export DIR", a.export_folder, "write the shipped scenarios to a folder");
  command.flag("--force", a.force, "with --export: rename changed files to NAME.old first");

  command
      .option("--replay FILE", a.replay,
              "send a recording of `cls match --record-rpc` to the Playmaker ENDPOINT")
      .of_group(kDebuggingGroup);
  command.option("--side SIDE", a.side, "side of the recording for --replay: left or right")
      .one_of({"left", "right"});
  command.option("--at", a.at, "with --replay: only decisions of this cycle")
      .of_group(kDebuggingGroup);
  command.option("--player", a.player, "with --replay: only calls of this player")
      .of_group(kDebuggingGroup)
      .range(1, proto::kTrainerNumber);

  command
      .option("--start-timeout", a.start_timeout_s,
              "seconds until Playmakers answer (default: that of cls.toml, else 20)")
      .of_group(kLimitsGroup)
      .above(0);
  add_match_option(command, "sandbox", a.sandbox);
  add_match_option(command, "sandbox_playmakers", a.sandbox_playmakers);
  add_tls_options(command, a.tls);
  command.flag("--strict", a.strict, "fail (exit 1) on any skipped scenario")
      .of_group(kOutputGroup);
  command.flag("--quiet", a.quiet, "print only failures and the summary").of_group(kOutputGroup);
}

}  // namespace cls::cli
