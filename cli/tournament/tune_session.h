// Common parts of the commands of `cls tune`: the configuration, the plan, and the final
// comparison.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/tournament/tournament_options.h"
#include "tournament/report/comparison.h"
#include "tournament/tuning/tune_report.h"
#include "tournament/tuning/tuning.h"

namespace cls::cli {

/// Reads tune.toml in `folder`, and its template. Prints errors; returns an exit code.
int read_tune_config(const std::filesystem::path& folder, tournament::TuneConfig& config);

/// Conditions of the matches and opponents, with paths relative to `conditions.folder`.
struct TuneSetup {
  tournament::TuneConfig tune;
  tournament::TournamentConfig conditions;
  std::vector<tournament::TeamEntry> opponents;
};

/// Reads tune.toml and cls.toml. Prints errors; returns an exit code.
int make_tune_setup(const TournamentOptions& options, TuneSetup& setup);

/// Writes the plan of a search into `folder`, or compares it with the one that is there. Prints
/// the first difference; returns an exit code.
int check_tune_plan(const std::filesystem::path& folder, const tournament::TuneConfig& config);

/// Names inside the folder.
inline constexpr const char* kTunePlanFile = "tune.plan";
inline constexpr const char* kBestFile = "best.toml";
inline constexpr const char* kVerdictFolder = "verdict";

/// The comparison of the best values with the start values on seeds that no generation used.
/// Prints errors; returns an exit code.
int make_verdict(const TuneSetup& setup, const tournament::Tuning& tuning,
                 const std::filesystem::path& folder, tournament::Comparison& comparison);

/// The verdict, if matches of it were played.
std::optional<tournament::TuneVerdict> known_verdict(const tournament::TuneConfig& config,
                                                     const std::filesystem::path& folder);

}  // namespace cls::cli
