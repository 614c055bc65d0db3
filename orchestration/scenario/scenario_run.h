// One run of a scenario: the situation is set up, played, and written down.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>

#include "base/result.h"
#include "orchestration/process/process_host.h"
#include "orchestration/scenario/run_record.h"
#include "orchestration/scenario/scenario.h"

namespace cls::orchestration::scenario {

struct RunSettings {
  std::uint64_t seed = 1;
  std::optional<match::Endpoint> against;  ///< plays the side under test instead
  process::ProcessHost* host = nullptr;    ///< for `run:` endpoints, with their logs in `folder`
  std::filesystem::path folder;
};

/// Plays to the end; a run that goes wrong is a record too (its result's end reason). The error is
/// about a match that could not be set up.
base::Result<RunRecord> run_scenario(const Scenario& scenario, const RunSettings& settings,
                                     const std::atomic<int>& stop_signal);

}  // namespace cls::orchestration::scenario
