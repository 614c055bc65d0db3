// `cls dev`: plays scenarios again whenever the files of a team change.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/suggestion.h"
#include "cli/match/command_difference.h"
#include "cli/match/file_watch.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/terminal.h"
#include "match/hooks/rpc_recorder.h"
#include "match/result/match_folder.h"
#include "process/command_plan.h"
#include "scenario/scenario_library.h"
#include "scenario/scenario_run.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Json;
using match::Endpoint;
using scenario::RunRecord;
using scenario::Scenario;

constexpr const char* kDevDescription =
    "play scenarios again whenever files change\n"
    "\n"
    "  cls dev                          tests/, in the folder of a team\n"
    "  cls dev tests/scores.json        one scenario\n"
    "  cls dev tests/ --against 'run:./run --port {port}'\n"
    "\n"
    "Prints what passes, where the commands differ from the run before, and errors\n"
    "of the Playmaker. A `run:` Playmaker is started again for each scenario. Ends\n"
    "with Ctrl-C.";

struct DevArguments {
  std::vector<std::string> scenarios;
  std::string against;
  std::string watched = ".";
  std::string folder = "runs/dev";
  bool json = false;
};

/// The last run of a scenario.
struct LastRun {
  bool passed = false;
  std::string text_log;  ///< of the last valid one; empty: there is none
};

class DevSession {
 public:
  DevSession(const DevArguments& arguments, process::ProcessHost& host,
             const std::atomic<int>& signal)
      : arguments_(arguments), host_(host), signal_(signal) {}

  /// The scenarios of a file or folder, or the shipped one of this name.
  static base::Result<std::vector<Scenario>> read(const std::string& name) {
    if (!base::absence(name)) {
      return scenario::read_scenarios(name, endpoint_of_team);
    }

    auto shipped = scenario::shipped_scenarios();
    if (!shipped) return shipped;

    std::vector<std::string_view> names;
    for (Scenario& scenario : *shipped) {
      if (scenario.name == name) return std::vector<Scenario>{std::move(scenario)};
      names.emplace_back(scenario.name);
    }
    return base::Error{
        fmt::format("unknown scenario '{}'{}", name, base::did_you_mean(name, names))};
  }

  /// The scenarios may have changed, too. An error is printed, and the next change tried.
  void play(const std::vector<std::string>& changed) {
    Json document = {{"schema", "cls.dev/1"}, {"changed", changed}, {"scenarios", Json::array()}};
    if (!changed.empty()) print("changed: {}\n", fmt::join(changed, ", "));
    shown_output_.clear();

    for (const std::string& name : arguments_.scenarios) {
      const auto scenarios = read(name);
      if (!scenarios) {
        print("cls: {}\n", scenarios.error().message);
        document["scenarios"].push_back({{"name", name}, {"problem", scenarios.error().message}});
        continue;
      }
      for (const Scenario& scenario : *scenarios) {
        if (signal_.load() != 0) return;
        document["scenarios"].push_back(play(scenario));
      }
    }

    if (arguments_.json) fmt::print("{}\n", base::json_line(document));
    std::fflush(stdout);
  }

 private:
  template <typename... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) const {
    if (!arguments_.json) fmt::print(format, std::forward<Values>(values)...);
  }

  Json play(const Scenario& scenario) {
    constexpr double kTimeToBuild = 600.0;
    scenario::RunSettings settings;
    settings.seed = scenario.seeds.front();
    settings.host = &host_;
    settings.folder = fs::absolute(fs::path(arguments_.folder) / scenario.name);
    settings.start_timeout_s = kTimeToBuild;

    if (!arguments_.against.empty()) {
      auto side = match::parse_endpoint(arguments_.against);
      if (!side) return problem(scenario, side.error().message);
      if (const auto loaded = load_files(*side); !loaded) {
        return problem(scenario, loaded.error().message);
      }
      settings.against = *std::move(side);
    }

    if (const auto created = base::create_folders(settings.folder); !created) {
      return problem(scenario, created.error().message);
    }
    const auto record = run_scenario(scenario, settings, signal_);
    if (!record) return problem(scenario, record.error().message);
    if (signal_.load() != 0) return Json(nullptr);
    return report(scenario, settings, *record);
  }

  Json problem(const Scenario& scenario, const std::string& text) const {
    print("FAIL  {}\n      {}\n", scenario.name, text);
    return {{"name", scenario.name}, {"passed", false}, {"problem", text}};
  }

  Json report(const Scenario& scenario, const scenario::RunSettings& settings,
              const RunRecord& record) {
    std::vector<std::string> failures = record.script_failures;
    for (const auto& check : scenario.checks) {
      const std::string failure = scenario::failure(check, record);
      if (!failure.empty()) {
        failures.push_back(fmt::format("line {}: {}: {}", check.line, check.name, failure));
      }
    }

    const bool passed = failures.empty();
    const bool color = !arguments_.json && stdout_supports_color();
    const std::string verdict = passed ? "ok" : "FAIL";
    print("{}{:<5}{} {}{}\n", color ? (passed ? "\x1b[32m" : "\x1b[31m") : "", verdict,
          color ? "\x1b[0m" : "", scenario.name, change_of_verdict(scenario, passed));

    Json document = {{"name", scenario.name},
                     {"seed", record.seed},
                     {"passed", passed},
                     {"failures", failures},
                     {"difference", nullptr},
                     {"errors", Json::array()},
                     {"message", record.result.message}};

    print_errors_of(scenario, settings, record, document);
    print_end(record);
    for (const std::string& failure : failures) {
      if (!is_consequence(failure, record)) print("      {}\n", failure);
    }

    LastRun& last = last_[scenario.name];
    if (record.result.valid()) {
      print_difference(scenario, record, document);
      last.text_log = record.text_log;
    }
    last.passed = passed;
    return document;
  }

  std::string change_of_verdict(const Scenario& scenario, bool passed) const {
    const auto last = last_.find(scenario.name);
    if (last == last_.end() || last->second.passed == passed) return {};
    return passed ? " (failed before)" : " (passed before)";
  }

  // Checks fail when the match does not take place, and some when the Playmaker has an error. Then
  // the cause is printed.
  static bool is_consequence(const std::string& failure, const RunRecord& record) {
    return !record.result.valid() || std::ranges::any_of(record.errors, [&](const auto& error) {
      return error && failure.find(error->message) != std::string::npos;
    });
  }

  // Why a match is invalid, with the last output of the program: a compiler names file and line. A
  // program with an error in decisions repeats that error.
  void print_end(const RunRecord& record) {
    if (record.result.valid()) return;
    print("      {}\n", record.result.message);

    const bool has_error = record.errors[0] || record.errors[1];
    if (!record.result.failure || has_error) return;
    constexpr std::size_t kLines = 10;
    const auto& output = record.result.failure->output;
    if (!output.empty() && output == shown_output_) {
      print("        the same output as above\n");
      return;
    }
    shown_output_ = output;
    for (std::size_t i = output.size() - std::min(output.size(), kLines); i < output.size(); ++i) {
      print("        {}\n", output[i]);
    }
  }

  void print_difference(const Scenario& scenario, const RunRecord& record, Json& document) const {
    const auto last = last_.find(scenario.name);
    if (last == last_.end() || last->second.text_log.empty()) return;

    const soccer::Side side = scenario.under_test.value_or(soccer::Side::kLeft);
    const auto difference =
        compare_commands(last->second.text_log, record.text_log, soccer::side_name(side));
    if (!difference) {
      print("      the same commands as before\n");
      return;
    }

    const auto shown = [](const std::string& commands) {
      return commands.empty() ? std::string("nothing") : commands;
    };
    print("      first difference: cycle {}, {}: {}, before {}\n", difference->cycle,
          difference->agent, shown(difference->now), shown(difference->before));
    print("      {} of {} decisions differ\n", difference->differ, difference->total);
    document["difference"] = {{"cycle", difference->cycle},   {"agent", difference->agent},
                              {"before", difference->before}, {"now", difference->now},
                              {"differ", difference->differ}, {"total", difference->total}};
  }

  // The State that caused an error becomes a recording, which is a test of that one call.
  void print_errors_of(const Scenario& scenario, const scenario::RunSettings& settings,
                       const RunRecord& record, Json& document) const {
    using match::kLeftErrorFile;
    using match::kRightErrorFile;
    for (const soccer::Side side : {soccer::Side::kLeft, soccer::Side::kRight}) {
      const bool left = side == soccer::Side::kLeft;
      const auto& error = record.errors.at(left ? 0 : 1);
      if (!error) continue;

      print("      {}\n", error->describe());
      const fs::path file =
          fs::path(arguments_.folder) / scenario.name / (left ? kLeftErrorFile : kRightErrorFile);

      recording::RecordingHeader header;
      header.set_seed(settings.seed);
      header.set_left_name("left");
      header.set_right_name("right");
      const auto written = match::write_error_recording(file, header, side, *error);
      if (written) {
        const Endpoint& endpoint =
            settings.against.value_or(scenario.sides.at(scenario::index_of(side)).playmaker);
        print("      its State again: cls test --replay {} {}\n",
              process::shell_quoted(file.string()), process::shell_quoted(endpoint.text));
      }

      document["errors"].push_back({{"side", soccer::side_name(side)},
                                    {"text", error->describe()},
                                    {"recording", written ? Json(file.string()) : Json(nullptr)}});
    }
  }

  const DevArguments& arguments_;
  process::ProcessHost& host_;
  const std::atomic<int>& signal_;
  std::map<std::string, LastRun> last_;
  std::vector<std::string> shown_output_;  // in this round, of a program that ended
};

// Waits until files differ from `versions` and no longer change; empty after a signal.
std::vector<std::string> wait_for_change(const fs::path& folder, FileVersions& versions,
                                         const std::atomic<int>& signal) {
  constexpr std::chrono::milliseconds kInterval{300};
  FileVersions seen = versions;
  while (signal.load() == 0) {
    std::this_thread::sleep_for(kInterval);
    FileVersions now = file_versions(folder);
    const bool settled = now == seen;
    seen = std::move(now);
    if (!settled || seen == versions) continue;
    std::vector<std::string> changed = changed_files(versions, seen);
    versions = std::move(seen);
    return changed;
  }
  return {};
}

int run_dev(DevArguments& arguments) {
  if (const auto why = base::why_no_folder(arguments.watched)) {
    return print_error(kNoInput, "--watch: {}: {}", arguments.watched, *why);
  }

  if (arguments.scenarios.empty()) {
    if (base::why_no_folder("tests")) {
      return print_error(kNoInput,
                         "dev: no folder tests/ here; name a scenario, or write some with "
                         "cls test --export tests/");
    }
    arguments.scenarios = {"tests"};
  }

  // An error inside of a file is for the next change; no change makes a mistyped name right.
  for (const std::string& name : arguments.scenarios) {
    if (!base::absence(name)) continue;
    TRY_OR(kNoInput, DevSession::read(name));
  }

  if (!arguments.against.empty()) {
    std::string name;
    TRY_STEP(resolve_team_name(arguments.against, name, ""));
    const auto side = parse_side(arguments.against, "");
    if (!side) return print_error(kUsage, "--against: " + side.error().message);
  }

  TRY_INIT_OR(kInternalError, auto host, process::ProcessHost::create());
  const std::atomic<int>& signal = watch_interrupts();
  DevSession session(arguments, host, signal);

  std::vector<std::string> changed;
  while (signal.load() == 0) {
    FileVersions versions = file_versions(arguments.watched);
    session.play(changed);

    if (signal.load() != 0) break;
    if (!arguments.json) {
      fmt::print("watching {} (Ctrl-C ends)\n", arguments.watched);
      std::fflush(stdout);
    }
    changed = wait_for_change(arguments.watched, versions, signal);
  }
  return signal_exit_code(signal);
}

}  // namespace

void add_dev_command(Command& app) {
  auto [command, arguments] = app.command("dev", kDevDescription, run_dev);
  command.group = kPlayCommands;
  command.starts_programs = true;

  command.option("SCENARIO", arguments.scenarios, "names, files or folders (default: tests/)");
  command.option("--against SIDE", arguments.against,
                 "SIDE that plays the side under test (default: as the scenario says)");
  command.option("--watch", arguments.watched, "folder whose files count (default: .)")
      .of_group(kOutputGroup)
      .placeholder("DIR");
  command.setting("--dir DIR", arguments.folder, "folder of logs and recordings");
  command.flag("--json", arguments.json, "print one line of JSON per round").of_group(kOutputGroup);
}

}  // namespace cls::cli
