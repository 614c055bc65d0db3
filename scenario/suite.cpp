// Distributes runs over threads and combines the results of their checks.
#include "scenario/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "base/system/parallel.h"
#include "match/result/match_folder.h"
#include "scenario/scenario_run.h"
#include "viewer/page/match_page.h"

namespace cls::scenario {
namespace {

namespace fs = std::filesystem;

/// Outcome of a run after its checks were evaluated.
struct RunOutcome {
  std::uint64_t seed = 0;
  std::string problem;                ///< why it could not be set up
  bool interrupted = false;           ///< by a signal, before its end
  std::vector<std::string> failures;  ///< by check; empty: held
  std::vector<std::string> script_failures;
  std::vector<std::string> fingerprints;
  bool against = false;  ///< a check counts this run as a failure
  fs::path folder;       ///< its logs, if the run failed
  fs::path page;         ///< that shows it, if the run failed and has a frame
  double seconds = 0.0;

  bool good() const { return problem.empty() && script_failures.empty() && !against; }
};

// Whether a single run counts against the check. For a check that must hold in some runs, that is
// a run in which it failed; for one that must hold in none, a run in which it held.
bool speaks_against(const Check& check, bool held) {
  if (!check.runs) return !held;
  const bool may_fail_in_all = check.runs->holds(0.0);
  return held ? may_fail_in_all && !check.runs->holds(1.0) : !may_fail_in_all;
}

constexpr const char* kFailures = "failures.txt";
constexpr const char* kPage = "match.html";

std::string folder_prefix(const Scenario& scenario) { return scenario.name + "-seed-"; }

fs::path run_folder(const fs::path& folder, const Scenario& scenario, std::uint64_t seed) {
  return folder / fmt::format("{}{}", folder_prefix(scenario), seed);
}

// Folders of this and earlier suites.
std::vector<fs::path> run_folders(const fs::path& folder, const Scenario& scenario) {
  std::vector<fs::path> found;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    const std::string prefix = folder_prefix(scenario);
    const bool is_run = name.starts_with(prefix) && name.size() > prefix.size() &&
                        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
    if (is_run) found.push_back(entry.path());
  }
  return found;
}

// Removes what a suite writes; a folder with other files stays.
void remove_run(const fs::path& folder) {
  std::error_code code;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    const bool written = name == match::kGameLogFile || name == match::kTextLogFile ||
                         name == kFailures || name == kPage || entry.path().extension() == ".log";
    if (written && entry.is_regular_file(code)) files.push_back(entry.path());
  }
  for (const fs::path& file : files) fs::remove(file, code);
  fs::remove(folder, code);
}

bool starts_programs(const Scenario& scenario, const SuiteOptions& options) {
  return (options.against && options.against->starts_programs()) ||
         scenario.sides[0].playmaker.starts_programs() ||
         scenario.sides[1].playmaker.starts_programs();
}

class SuiteRun {
 public:
  SuiteRun(const std::vector<Scenario>& scenarios, const SuiteOptions& options,
           const std::function<void(const ScenarioVerdict&)>& on_done,
           const std::atomic<int>& stop_signal, process::ProcessHost* host,
           std::string host_problem)
      : scenarios_(scenarios),
        options_(options),
        on_done_(on_done),
        stop_signal_(stop_signal),
        host_(host),
        host_problem_(std::move(host_problem)) {
    for (const Scenario& scenario : scenarios) {
      verdicts_.scenarios.emplace_back().scenario = &scenario;
      outcomes_.emplace_back();
      open_.push_back(0);
      plan(scenario);
    }
  }

  SuiteVerdict play() {
    base::parallel_for(tasks_.size(), base::index(options_.jobs),
                       [this](std::size_t task) { work(tasks_[task]); });
    return std::move(verdicts_);
  }

 private:
  struct Task {
    std::size_t scenario = 0;
    std::size_t run = 0;
    std::uint64_t seed = 0;
  };

  void plan(const Scenario& scenario) {
    const std::size_t index = verdicts_.scenarios.size() - 1;
    ScenarioVerdict& verdict = verdicts_.scenarios.back();
    if (const std::string why = why_skipped(scenario); !why.empty()) {
      verdict.verdict = Verdict::kSkipped;
      verdict.reason = why;
      on_done_(verdict);
      return;
    }

    verdict.seeds = options_.seed ? std::vector<std::uint64_t>{*options_.seed} : scenario.seeds;
    outcomes_[index].resize(verdict.seeds.size());
    open_[index] = verdict.seeds.size();
    for (std::size_t run = 0; run < verdict.seeds.size(); ++run) {
      tasks_.push_back({index, run, verdict.seeds[run]});
    }
  }

  // Empty: it is played. An external team on the side under test cannot pass checks of Playmakers.
  std::string why_skipped(const Scenario& scenario) const {
    if (!options_.against) return "";
    if (!scenario.under_test) return "no side under test";
    if (options_.against->has_playmaker()) return "";

    const auto check = std::ranges::find(scenario.checks, scenario.under_test, playmaker_of);
    if (check == scenario.checks.end()) return "";
    return fmt::format("line {}: {}", check->line, kExternalTeamHasNoPlaymaker);
  }

  bool has_external_team(const Scenario& scenario) const {
    return (options_.against && !options_.against->has_playmaker()) ||
           !scenario.sides[0].playmaker.has_playmaker() ||
           !scenario.sides[1].playmaker.has_playmaker();
  }

  void work(const Task& task) {
    RunOutcome outcome;
    outcome.seed = task.seed;
    if (stop_signal_.load() == 0) {
      play(task, outcome);
    } else {
      outcome.interrupted = true;
    }

    const std::lock_guard lock(mutex_);
    outcomes_[task.scenario][task.run] = std::move(outcome);
    if (--open_[task.scenario] == 0) conclude(task.scenario);
  }

  void play(const Task& task, RunOutcome& outcome) {
    const Scenario& scenario = scenarios_[task.scenario];
    if (host_ == nullptr && starts_programs(scenario, options_)) {
      outcome.problem = host_problem_;
      return;
    }

    const RunSettings settings = {
        .seed = task.seed,
        .against = options_.against,
        .host = host_,
        .folder = fs::absolute(run_folder(options_.folder, scenario, task.seed)),
        .start_timeout_s = options_.start_timeout_s,
        .sandbox = options_.sandbox,
        .sandbox_playmakers = options_.sandbox_playmakers};
    if (host_ != nullptr) {
      if (const auto created = base::create_folders(settings.folder); !created) {
        outcome.problem = created.error().message;
        return;
      }
    }

    // External teams use fixed ports and cannot play two matches in parallel.
    const auto alone = has_external_team(scenario) ? std::unique_lock(external_teams_)
                                                   : std::unique_lock<std::mutex>();
    const auto record = run_scenario(scenario, settings, stop_signal_);
    if (!record) {
      outcome.problem = record.error().message;
      return;
    }

    outcome.seconds = record->seconds;
    if (stop_signal_.load() != 0 && !record->result.valid()) {
      outcome.interrupted = true;
      return;
    }

    outcome.script_failures = record->script_failures;
    for (const Check& check : scenario.checks) {
      outcome.failures.push_back(failure(check, *record));
      if (speaks_against(check, outcome.failures.back().empty())) outcome.against = true;
      if (const auto* golden = std::get_if<GoldenCheck>(&check.what)) {
        outcome.fingerprints.push_back(fingerprint(*golden, *record));
      }
    }

    if (!outcome.good()) {
      keep(options_.folder / settings.folder.filename(), *record, outcome);
    }
  }

  static void keep(const fs::path& folder, const RunRecord& record, RunOutcome& outcome) {
    std::error_code code;
    fs::create_directories(folder, code);
    std::string report;
    for (const std::string& line : outcome.failures) {
      if (!line.empty()) report += line + "\n";
    }

    for (const std::string& line : outcome.script_failures) report += line + "\n";
    const bool kept = base::write_file(folder / match::kGameLogFile, record.game_log) &&
                      base::write_file(folder / match::kTextLogFile, record.text_log) &&
                      base::write_file(folder / kFailures, report);
    if (kept) outcome.folder = folder;
    const std::string page =
        viewer::page_of_logs(record.game_log, record.text_log, match::kGameLogFile);
    if (!page.empty() && base::write_file(folder / kPage, page)) outcome.page = folder / kPage;
  }

  std::string repeat_command(const Scenario& scenario, std::uint64_t seed) const {
    std::string command = fmt::format("cls test {} --seed {}", scenario.argument, seed);
    if (options_.against) command += fmt::format(" --against '{}'", options_.against_text);
    return command;
  }

  void conclude(std::size_t index) {
    ScenarioVerdict& verdict = verdicts_.scenarios[index];
    const Scenario& scenario = *verdict.scenario;
    const std::vector<RunOutcome>& runs = outcomes_[index];
    bool good = true;
    for (std::size_t i = 0; i < scenario.checks.size(); ++i) {
      verdict.checks.push_back(
          conclude_check(scenario.checks[i], i, runs, options_.seed.has_value()));
      good = good && verdict.checks.back().passed;
    }

    good = conclude_scripts(verdict, runs) && good;
    for (const RunOutcome& run : runs) {
      verdict.seconds += run.seconds;
      if (!run.problem.empty()) {
        good = false;
        verdict.reason = run.problem;
      }
    }

    verdict.fingerprints = runs.front().fingerprints;
    const auto is_interrupted = [](const RunOutcome& run) { return run.interrupted; };
    if (std::ranges::any_of(runs, is_interrupted)) {
      verdict.verdict = Verdict::kInterrupted;
      verdict.reason = "interrupted";
      verdict.checks.clear();
    } else if (!good) {
      verdict.verdict = Verdict::kFailed;
      // Possibly no single run failed, only their count.
      auto bad = std::ranges::find_if(runs, [](const RunOutcome& run) { return !run.good(); });
      if (bad == runs.end()) bad = runs.begin();
      verdict.replay = bad->folder.string();
      verdict.page = bad->page.string();
      verdict.rerun = repeat_command(scenario, bad->seed);
    }

    clear_folders(verdict, runs);
    on_done_(verdict);
  }

  // Tolerated seeds are not failures; folders of earlier failures are obsolete.
  void clear_folders(const ScenarioVerdict& verdict, const std::vector<RunOutcome>& runs) const {
    const Scenario& scenario = *verdict.scenario;
    const bool failed = verdict.verdict == Verdict::kFailed;
    std::vector<fs::path> kept;
    for (const RunOutcome& run : runs) {
      const fs::path folder = run_folder(options_.folder, scenario, run.seed);
      const bool keeps = failed && !run.good();
      if (keeps) kept.push_back(folder);
      if (!keeps && !run.interrupted) remove_run(folder);
    }
    if (verdict.verdict == Verdict::kInterrupted || options_.seed) return;

    for (const fs::path& folder : run_folders(options_.folder, scenario)) {
      if (std::ranges::find(kept, folder) == kept.end()) remove_run(folder);
    }
  }

  // With one seed given, counts over runs are meaningless: the run is judged alone.
  static CheckVerdict conclude_check(const Check& check, std::size_t index,
                                     const std::vector<RunOutcome>& runs, bool one_seed) {
    const bool counts = check.runs && !one_seed;
    CheckVerdict verdict;
    verdict.name = check.name;
    verdict.line = check.line;

    for (const RunOutcome& run : runs) {
      if (!run.problem.empty() || run.interrupted) continue;
      ++verdict.runs;
      if (run.failures[index].empty()) {
        ++verdict.held;
      } else if (!verdict.seed) {
        verdict.seed = run.seed;
        verdict.detail = run.failures[index];
      }
    }

    verdict.passed = counts              ? check.runs->holds(static_cast<double>(verdict.held))
                     : verdict.runs == 0 ? true
                                         : !speaks_against(check, verdict.held == verdict.runs);
    if (!verdict.passed && verdict.detail.empty()) verdict.detail = "held";
    if (counts && !verdict.passed) {
      verdict.detail =
          fmt::format("held in {} of {} runs, not {}{}{}", verdict.held, verdict.runs,
                      check.runs->text(), verdict.seed ? "; first failure: " : "", verdict.detail);
    }

    return verdict;
  }

  // Failed expectations of mock scripts count as one check.
  static bool conclude_scripts(ScenarioVerdict& verdict, const std::vector<RunOutcome>& runs) {
    for (const RunOutcome& run : runs) {
      if (run.script_failures.empty()) continue;
      verdict.checks.push_back({.name = "expectations of mock scripts",
                                .line = 1,
                                .passed = false,
                                .runs = static_cast<int>(runs.size()),
                                .detail = fmt::format("{}", fmt::join(run.script_failures, "; ")),
                                .seed = run.seed});
      return false;
    }
    return true;
  }

  const std::vector<Scenario>& scenarios_;
  const SuiteOptions& options_;
  const std::function<void(const ScenarioVerdict&)>& on_done_;
  const std::atomic<int>& stop_signal_;
  process::ProcessHost* host_;
  std::string host_problem_;  ///< why programs cannot be started

  std::vector<Task> tasks_;
  std::mutex external_teams_;  ///< serializes runs with external teams
  std::mutex mutex_;
  std::vector<std::vector<RunOutcome>> outcomes_;
  std::vector<std::size_t> open_;  ///< remaining runs, by scenario
  SuiteVerdict verdicts_;
};

}  // namespace

int SuiteVerdict::count(Verdict verdict) const {
  return static_cast<int>(std::ranges::count_if(
      scenarios, [verdict](const auto& each) { return each.verdict == verdict; }));
}

SuiteVerdict run_suite(const std::vector<Scenario>& scenarios, const SuiteOptions& options,
                       const std::function<void(const ScenarioVerdict&)>& on_done,
                       const std::atomic<int>& stop_signal) {
  std::optional<process::ProcessHost> host;
  std::string problem;
  const auto starts = [&](const Scenario& scenario) { return starts_programs(scenario, options); };
  if (std::ranges::any_of(scenarios, starts)) {
    auto created = process::ProcessHost::create();
    if (created) host.emplace(*std::move(created));
    if (!created) problem = created.error().message;
  }
  return SuiteRun(scenarios, options, on_done, stop_signal, host ? &*host : nullptr, problem)
      .play();
}

}  // namespace cls::scenario
