// Many scenarios, each with its seeds, on several threads; what came of them.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/scenario/run_record.h"
#include "orchestration/scenario/scenario.h"

namespace cls::orchestration::scenario {

struct SuiteOptions {
  int jobs = 1;
  std::optional<std::uint64_t> seed;  ///< instead of the scenarios' own
  std::optional<match::Endpoint> against;
  std::string against_text;      ///< for the command that repeats a run
  std::filesystem::path folder;  ///< where failing runs are kept; created when one fails
};

/// One demand over all runs of a scenario.
struct CheckVerdict {
  std::string name;
  int line = 0;
  bool passed = true;
  int held = 0;  ///< runs in which it held
  int runs = 0;
  std::string detail;                 ///< of the first run in which it did not hold
  std::optional<std::uint64_t> seed;  ///< of that run
};

enum class Verdict { kPassed, kFailed, kSkipped };

struct ScenarioVerdict {
  const Scenario* scenario = nullptr;
  Verdict verdict = Verdict::kPassed;
  std::string reason;  ///< why it was skipped, or could not be played
  std::vector<CheckVerdict> checks;
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> fingerprints;  ///< of golden checks, in their order, of the first run
  std::string replay;                     ///< folder with the logs of the first failing run
  std::string repeat;                     ///< command that plays it again
  double seconds = 0.0;                   ///< wall time of all runs together
};

struct SuiteVerdict {
  std::vector<ScenarioVerdict> scenarios;  ///< in the order given
  int count(Verdict verdict) const;
  bool passed() const { return count(Verdict::kFailed) == 0; }
};

/// `on_done` is called after each scenario, from any thread, one at a time. A signal skips what has
/// not been played.
SuiteVerdict run_suite(const std::vector<Scenario>& scenarios, const SuiteOptions& options,
                       const std::function<void(const ScenarioVerdict&)>& on_done,
                       const std::atomic<int>& stop_signal);

}  // namespace cls::orchestration::scenario
