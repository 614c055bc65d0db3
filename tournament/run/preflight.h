// Checks before the first match of a run.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "league/matches/fixture.h"
#include "match/sides/endpoint_check.h"
#include "tournament/config/config.h"

namespace cls::tournament {

/// Why no match, or none of a team, could start.
struct StartProblem {
  match::EndpointProblem::Kind kind = match::EndpointProblem::Kind::kUnreachable;
  std::string text;  ///< "team RED (localhost:50051): nothing listens ..."
};

/// Checks all teams of the valid `config` concurrently, see match::check_endpoint(), and the
/// program of the soccer server. Only the scripts and behaviors of mocks if matches run on a
/// cluster.
std::vector<StartProblem> check_start(const TournamentConfig& config,
                                      std::chrono::milliseconds patience);

/// Warnings about the host, one line each: more parallel matches than cores, too little disk space,
/// external teams without a sandbox, earlier matches played by another version of cls. `matches`:
/// scheduled so far; `to_play`: expected number of further matches.
std::vector<std::string> host_warnings(const TournamentConfig& config,
                                       std::span<const ScheduledMatch> matches, double to_play,
                                       const std::filesystem::path& folder);

/// The seconds that `to_play` matches take on this host, from the matches played so far or, in real
/// time, from their length. Nothing if unknown.
std::optional<double> expected_seconds(const TournamentConfig& config,
                                       std::span<const ScheduledMatch> matches, double to_play);

}  // namespace cls::tournament
