// Plays one run of a scenario and returns its record.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>

#include "base/result.h"
#include "match/terms/match_options.h"
#include "process/process_host.h"
#include "scenario/run_record.h"
#include "scenario/scenario.h"

namespace cls::scenario {

struct RunSettings {
  std::uint64_t seed = 1;
  std::optional<match::Endpoint> against;  ///< replaces the side under test
  process::ProcessHost* host = nullptr;    ///< for `run:` sides; their logs go to `folder`
  std::filesystem::path folder;
  std::optional<double> start_timeout_s;         ///< none: that of matches
  match::Sandbox sandbox = match::Sandbox::kOn;  ///< as of matches
  bool sandbox_playmakers = false;               ///< the same
};

/// Plays the run. A failed run has a record too (see its result's end reason); an error means that
/// the match could not be set up.
base::Result<RunRecord> run_scenario(const Scenario& scenario, const RunSettings& settings,
                                     const std::atomic<int>& stop_signal);

}  // namespace cls::scenario
