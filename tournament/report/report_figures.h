// Figures of a report that come from the matches, not from their scores: latencies, hosts, times.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "league/matches/fixture.h"

namespace cls::tournament {

/// How a team's Playmaker replied. Latencies in microseconds.
struct PlaymakerFigures {
  int matches = 0;  ///< with decisions
  std::int64_t decisions = 0;
  std::int64_t late = 0;
  std::int64_t missed = 0;
  double p50_us = 0.0;  ///< median player, median match
  double p95_us = 0.0;  ///< this and the next two: slowest player, slowest match
  double p99_us = 0.0;
  double max_us = 0.0;
};

/// One element per team.
std::vector<PlaymakerFigures> playmaker_figures(std::size_t teams,
                                                std::span<const ScheduledMatch> matches);

/// The matches that a host played.
struct HostFigures {
  std::string host;
  int matches = 0;
  std::int64_t decisions = 0;
  std::int64_t missed = 0;         ///< decisions without a usable reply
  double cycles_per_second = 0.0;  ///< mean of its matches
  /// More than twice the share of missed decisions of all other hosts together, by more than three
  /// standard errors.
  bool outlier = false;

  double missed_share() const {
    return decisions == 0 ? 0.0 : static_cast<double>(missed) / static_cast<double>(decisions);
  }
};

/// By name. Matches without a known host are left out.
std::vector<HostFigures> host_figures(std::span<const ScheduledMatch> matches);

/// UTC, ISO 8601; empty while no match was played.
struct TimeSpan {
  std::string first_start;
  std::string last_end;
};
TimeSpan time_span(std::span<const ScheduledMatch> matches);

/// Each distinct text once, sorted: versions of cls ("cls 1.2") and of the soccer server.
std::vector<std::string> versions(std::span<const ScheduledMatch> matches);

}  // namespace cls::tournament
