// `cls test`: chooses scenarios, plays them, tells what came of them.
#include "cli/match/test_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "cli/support/ci_reports.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/side_script.h"
#include "cli/support/tls_options.h"
#include "orchestration/match/hooks/rpc_replay.h"
#include "orchestration/scenario/scenario_library.h"
#include "orchestration/scenario/suite.h"
#include "orchestration/scenario/suite_report.h"
#include "soccer/side_name.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using orchestration::scenario::Scenario;
using orchestration::scenario::SuiteOptions;
using orchestration::scenario::SuiteVerdict;
using orchestration::scenario::Verdict;

constexpr const char* kDescription =
    "Plays scenarios and checks what comes of them.\n"
    "\n"
    "  cls test                                   all that come with cls\n"
    "  cls test --against localhost:50051         with your Playmaker on the side under test\n"
    "  cls test my_scenarios/ --junit report.xml  yours, for CI (docs/testing.md)\n"
    "  cls test referee_corner_kick --seed 3      one of them, one seed\n"
    "  cls test --replay FILE localhost:50051     a recorded match: which replies differ?";

struct Arguments {
  TlsOptions tls;
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
  bool json = false;
  bool list = false;
  bool bless = false;
  bool quiet = false;
  CiReports reports;
};

/// A mistake with the exit code it leads to.
struct Refusal {
  ExitCode code = kUsage;
  std::string message;
};

// `*` stands for anything; a pattern without it may be anywhere in the name.
bool fits(std::string_view pattern, std::string_view name) {
  if (pattern.find('*') == std::string_view::npos) return name.find(pattern) != std::string::npos;
  std::size_t at = 0;
  bool first = true;
  while (true) {
    const std::size_t star = std::min(pattern.find('*'), pattern.size());
    const std::string_view part = pattern.substr(0, star);
    const bool last = star == pattern.size();
    const std::size_t found = last && name.size() >= part.size() + at
                                  ? std::max(at, name.size() - part.size())
                                  : name.find(part, at);
    if (found == std::string_view::npos || name.substr(found, part.size()) != part) return false;
    if (first && found != 0) return false;
    if (last) return true;
    at = found + part.size();
    pattern.remove_prefix(star + 1);
    first = false;
  }
}

std::optional<Refusal> add_file(const std::string& word, std::vector<Scenario>& chosen) {
  if (!fs::exists(word)) return Refusal{kNoInput, fmt::format("{}: no such file", word)};
  auto read = orchestration::scenario::read_scenarios(word);
  if (!read) return Refusal{kBadData, read.error().message};
  chosen.insert(chosen.end(), read->begin(), read->end());
  return std::nullopt;
}

// A word with a slash or ".json" is a file or folder, any other a shipped scenario's name first.
bool names_file(const std::string& word) {
  return word.find('/') != std::string::npos || word.ends_with(".json");
}

std::optional<Refusal> add_named(const std::string& word, const std::vector<Scenario>& shipped,
                                 std::vector<Scenario>& chosen) {
  std::vector<std::string_view> names;
  for (const Scenario& scenario : shipped) {
    if (scenario.name == word) {
      chosen.push_back(scenario);
      return std::nullopt;
    }
    names.push_back(scenario.name);
  }
  if (fs::exists(word)) return add_file(word, chosen);
  return Refusal{kNoInput,
                 fmt::format("no scenario '{}'{}", word, base::did_you_mean(word, names))};
}

// "2/4": the second quarter, counted from 1.
std::optional<Refusal> keep_shard(const std::string& shard, std::vector<Scenario>& scenarios) {
  std::size_t index = 0;
  std::size_t count = 0;
  const std::size_t slash = shard.find('/');
  const char* end = shard.data() + shard.size();
  if (slash != std::string::npos) {
    std::from_chars(shard.data(), shard.data() + slash, index);
    std::from_chars(shard.data() + slash + 1, end, count);
  }
  if (index < 1 || count < index) {
    return Refusal{kUsage, fmt::format("--shard '{}': write K/N, 1/4 to 4/4", shard)};
  }
  std::vector<Scenario> kept;
  for (std::size_t i = index - 1; i < scenarios.size(); i += count) kept.push_back(scenarios[i]);
  scenarios = std::move(kept);
  return std::nullopt;
}

std::optional<Refusal> choose(const Arguments& arguments, std::vector<Scenario>& chosen) {
  std::vector<Scenario> shipped;
  if (!std::all_of(arguments.scenarios.begin(), arguments.scenarios.end(), names_file) ||
      arguments.scenarios.empty()) {
    auto read = orchestration::scenario::shipped_scenarios();
    if (!read) return Refusal{kInternalError, read.error().message};
    shipped = *std::move(read);
  }
  if (arguments.scenarios.empty()) chosen = shipped;
  for (const std::string& word : arguments.scenarios) {
    auto refusal = names_file(word) ? add_file(word, chosen) : add_named(word, shipped, chosen);
    if (refusal) return refusal;
  }
  const auto unwanted = [&](const Scenario& scenario) {
    return !fits(arguments.filter, scenario.name);
  };
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), unwanted), chosen.end());
  if (chosen.empty()) {
    return Refusal{kUsage, fmt::format("--filter '{}' fits no scenario", arguments.filter)};
  }
  return arguments.shard.empty() ? std::nullopt : keep_shard(arguments.shard, chosen);
}

std::optional<Refusal> complete(const Arguments& arguments, SuiteOptions& options) {
  options.seed = arguments.seed;
  options.folder = arguments.folder;
  options.jobs = arguments.jobs;
  if (options.jobs == 0) options.jobs = static_cast<int>(std::thread::hardware_concurrency());
  options.jobs = std::max(options.jobs, 1);
  if (arguments.against.empty()) return std::nullopt;
  auto endpoint = orchestration::match::parse_endpoint(arguments.against);
  if (!endpoint) return Refusal{kUsage, "--against: " + endpoint.error().message};
  int read = read_script_of(*endpoint);
  if (read == kDone) read = read_tls_files(*endpoint, arguments.tls);
  if (read != kDone) return Refusal{static_cast<ExitCode>(read), ""};
  options.against = *std::move(endpoint);
  options.against_text = arguments.against;
  // One Playmaker of a user's need not be able to play several matches at once.
  const bool shared = options.against->kind != orchestration::match::Endpoint::Kind::kMock;
  if (shared && arguments.jobs == 0) options.jobs = 1;
  return std::nullopt;
}

int list(const std::vector<Scenario>& scenarios) {
  for (const Scenario& scenario : scenarios) {
    fmt::print("{:<32} {}\n", scenario.name, scenario.about);
  }
  return kDone;
}

// Copies of the shipped scenarios, to begin one's own with.
int export_to(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  for (const orchestration::scenario::ShippedFile& file :
       orchestration::scenario::shipped_files()) {
    const auto written = base::write_file(folder / file.name, file.text);
    if (written) continue;
    fmt::print(stderr, "cls: {}\n", written.error().message);
    return kCannotCreate;
  }
  fmt::print("{} files in {}\n", orchestration::scenario::shipped_files().size(), folder.string());
  return kDone;
}

// True when blessing has made everything right.
bool only_golden_failed(const SuiteVerdict& suite) {
  for (const auto& verdict : suite.scenarios) {
    if (verdict.verdict == Verdict::kFailed && !verdict.reason.empty()) return false;
    for (std::size_t i = 0; i < verdict.checks.size(); ++i) {
      const auto& checks = verdict.scenario->checks;
      const bool golden =
          i < checks.size() &&
          std::holds_alternative<orchestration::scenario::GoldenCheck>(checks[i].what);
      if (!verdict.checks[i].passed && !golden) return false;
    }
  }
  return true;
}

int tell(const Arguments& arguments, const SuiteVerdict& suite, double seconds) {
  if (arguments.json) {
    fmt::print("{}", to_json(suite));
  } else {
    fmt::print("{}", summary(suite, seconds));
  }
  const ExitCode handed_out = hand_out(arguments.reports, to_junit(suite), to_annotations(suite));
  if (handed_out != kDone) return handed_out;
  if (arguments.bless) {
    const auto blessed = bless(suite);
    if (!blessed) {
      fmt::print(stderr, "cls: {}\n", blessed.error().message);
      return kCannotCreate;
    }
    fmt::print(stderr, "{} golden values changed\n", *blessed);
    return only_golden_failed(suite) ? kDone : kAnswerIsNo;
  }
  return suite.passed() ? kDone : kAnswerIsNo;
}

int refuse(const Refusal& refusal) {
  if (!refusal.message.empty()) fmt::print(stderr, "cls: {}\n", refusal.message);
  return refusal.code;
}

// What the words say about a replay: its one ENDPOINT.
std::optional<Refusal> complete(const Arguments& arguments,
                                orchestration::match::ReplayOptions& options) {
  if (arguments.scenarios.size() != 1) return Refusal{kUsage, "--replay FILE needs one ENDPOINT"};
  auto endpoint = orchestration::match::parse_endpoint(arguments.scenarios.front());
  if (!endpoint) return Refusal{kUsage, endpoint.error().message};
  if (!endpoint->has_playmaker()) return Refusal{kUsage, "--replay asks a Playmaker, not a team"};
  int read = read_script_of(*endpoint);
  if (read == kDone) read = read_tls_files(*endpoint, arguments.tls);
  if (read != kDone) return Refusal{static_cast<ExitCode>(read), ""};
  options.endpoint = *std::move(endpoint);
  options.file = arguments.replay;
  options.folder = arguments.folder;
  if (!fs::exists(options.file)) return Refusal{kNoInput, options.file + ": no such file"};
  if (options.endpoint.starts_programs()) fs::create_directories(options.folder);
  if (arguments.side.empty()) return std::nullopt;
  options.side = soccer::side_named(arguments.side);
  if (!options.side) {
    return Refusal{kUsage, fmt::format("--side '{}': must be left or right", arguments.side)};
  }
  return std::nullopt;
}

int run_replay(const Arguments& arguments) {
  constexpr std::size_t kShownDifferences = 20;
  orchestration::match::ReplayOptions options;
  if (const auto refusal = complete(arguments, options)) return refuse(*refusal);
  const std::atomic<int>& signal = watch_interrupts();
  const auto result = replay_recording(options, signal);
  if (!result) {
    const bool about_file = result.error().message.rfind(options.file, 0) == 0;
    return refuse({about_file ? kBadData : kUnavailable, result.error().message});
  }
  fmt::print("{}", arguments.json ? to_json(*result) : to_text(*result, kShownDifferences));
  if (result->interrupted) return signal.load() == SIGTERM ? kTerminated : kInterrupted;
  return result->differences.empty() ? kDone : kAnswerIsNo;
}

int run_test_command(const Arguments& arguments) {
  if (!arguments.replay.empty()) return run_replay(arguments);
  if (!arguments.export_folder.empty()) return export_to(arguments.export_folder);
  std::vector<Scenario> scenarios;
  if (const auto refusal = choose(arguments, scenarios)) return refuse(*refusal);
  if (arguments.list) return list(scenarios);
  SuiteOptions options;
  if (const auto refusal = complete(arguments, options)) return refuse(*refusal);
  const auto on_done = [&](const orchestration::scenario::ScenarioVerdict& verdict) {
    const bool wanted = verdict.verdict == Verdict::kFailed || !arguments.quiet;
    if (!wanted) return;
    fmt::print(arguments.json ? stderr : stdout, "{}", to_text(verdict));
    std::fflush(arguments.json ? stderr : stdout);
  };
  const std::atomic<int>& signal = watch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const SuiteVerdict suite = run_suite(scenarios, options, on_done, signal);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const int code = tell(arguments, suite, took.count());
  if (signal.load() != 0) return signal.load() == SIGTERM ? kTerminated : kInterrupted;
  return code;
}

}  // namespace

void add_test_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("test", kDescription);
  Arguments& a = *arguments;
  command->add_option("SCENARIO", a.scenarios, "names, files or folders (all that come with cls)");
  command->add_option("--against", a.against, "a side form: plays the side under test");
  command->add_option("--filter", a.filter, "only names that contain this; * stands for anything");
  command->add_option("--seed", a.seed, "only this seed");
  command->add_option("--shard", a.shard, "K/N: the K-th of N parts");
  command->add_option("--jobs", a.jobs, "runs at once (processors; 1 against your Playmaker)")
      ->check(CLI::Range(1, 1000));
  add_ci_options(*command, a.reports);
  command->add_flag("--json", a.json, "print the result document, nothing else");
  command->add_option("--dir", a.folder, "where failing runs are kept (runs/test)");
  command->add_flag("--bless", a.bless, "take what golden checks find as right");
  command->add_flag("--list", a.list, "only names and descriptions");
  command->add_option("--export", a.export_folder, "write the shipped scenarios into a folder");
  command->add_option("--replay", a.replay,
                      "asks the Playmaker ENDPOINT what `cls match --record-rpc` recorded");
  command->add_option("--side", a.side, "whose calls --replay asks: left or right");
  add_tls_options(*command, a.tls);
  command->add_flag("--quiet", a.quiet, "only failures and the summary");
  command->callback([arguments, &exit_code] { exit_code = run_test_command(*arguments); });
}

}  // namespace cls::cli
