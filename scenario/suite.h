// Runs scenarios over their seeds on several threads and collects the verdicts.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "match/terms/match_options.h"
#include "scenario/scenario.h"

namespace cls::scenario {

struct SuiteOptions {
  int jobs = 1;
  std::optional<std::uint64_t> seed;  ///< overrides the seeds of the scenarios
  std::optional<match::Endpoint> against;
  std::string against_text;                      ///< for the command that reruns a seed
  match::Sandbox sandbox = match::Sandbox::kOn;  ///< of external teams, as in matches
  bool sandbox_playmakers = false;               ///< of `run:` sides, as in matches
  std::optional<double> start_timeout_s;         ///< none: that of matches
  std::filesystem::path
      folder;  ///< logs and pages of failed runs; created on demand, cleared when they pass
};

/// One check over all runs of a scenario.
struct CheckVerdict {
  std::string name;
  int line = 0;
  bool passed = true;
  int held = 0;  ///< runs in which it held
  int runs = 0;
  std::string detail;                 ///< of the first run in which it did not hold
  std::optional<std::uint64_t> seed;  ///< of that run
};

enum class Verdict {
  kPassed,
  kFailed,
  kSkipped,
  kInterrupted,  ///< a signal ended the suite before all runs were played
};

struct ScenarioVerdict {
  const Scenario* scenario = nullptr;
  Verdict verdict = Verdict::kPassed;
  std::string reason;  ///< why it was skipped or could not be set up
  std::vector<CheckVerdict> checks;
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> fingerprints;  ///< of the golden checks in the first run, in order
  std::string replay;                     ///< folder with logs of the first failed run
  std::string page;                       ///< page that shows that run; empty: none
  std::string rerun;                      ///< command that reruns it
  double seconds = 0.0;                   ///< wall time of all runs
};

struct SuiteVerdict {
  std::vector<ScenarioVerdict> scenarios;  ///< in the order given
  int count(Verdict verdict) const;
  bool passed() const { return count(Verdict::kFailed) == 0; }
};

/// Calls `on_done` after each scenario, from any thread, never concurrently. After a signal the
/// scenarios that have not been played to the end are interrupted.
///
/// SuiteOptions::folder then has a folder NAME-seed-N for each failed run of a failed scenario.
/// Those of earlier suites that passed now are removed.
SuiteVerdict run_suite(const std::vector<Scenario>& scenarios, const SuiteOptions& options,
                       const std::function<void(const ScenarioVerdict&)>& on_done,
                       const std::atomic<int>& stop_signal);

}  // namespace cls::scenario
