// Sums, medians and maxima over matches.
#include "tournament/report/report_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/median.h"

namespace cls::tournament {
namespace {

void add_side(PlaymakerFigures& figures, std::vector<double>& medians, const SideStats& side) {
  if (side.decisions == 0) return;
  ++figures.matches;
  figures.decisions += side.decisions;
  figures.late += side.late;
  figures.missed += side.missed;
  figures.p95_us = std::max(figures.p95_us, side.rpc_p95_us);
  figures.p99_us = std::max(figures.p99_us, side.rpc_p99_us);
  figures.max_us = std::max(figures.max_us, side.rpc_max_us);
  medians.push_back(side.rpc_p50_us);
}

void mark_outliers(std::vector<HostFigures>& hosts) {
  constexpr double kMinRatio = 2.0;
  constexpr double kMinErrors = 3.0;
  HostFigures all;
  for (const HostFigures& host : hosts) {
    all.decisions += host.decisions;
    all.missed += host.missed;
  }

  for (HostFigures& host : hosts) {
    HostFigures others;
    others.decisions = all.decisions - host.decisions;
    others.missed = all.missed - host.missed;
    if (host.decisions == 0 || others.decisions == 0) continue;

    const double share = all.missed_share();
    const double error = std::sqrt(
        share * (1 - share) *
        (1.0 / static_cast<double>(host.decisions) + 1.0 / static_cast<double>(others.decisions)));
    const double difference = host.missed_share() - others.missed_share();
    host.outlier =
        host.missed_share() > kMinRatio * others.missed_share() && difference > kMinErrors * error;
  }
}

}  // namespace

std::vector<PlaymakerFigures> playmaker_figures(std::size_t teams,
                                                std::span<const ScheduledMatch> matches) {
  std::vector<PlaymakerFigures> figures(teams);
  std::vector<std::vector<double>> medians(teams);
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome) continue;
    const std::size_t left = base::index(match.fixture.left);
    const std::size_t right = base::index(match.fixture.right);
    add_side(figures[left], medians[left], match.outcome->left);
    add_side(figures[right], medians[right], match.outcome->right);
  }

  for (std::size_t team = 0; team < teams; ++team)
    figures[team].p50_us = base::median(medians[team]);
  return figures;
}

std::vector<HostFigures> host_figures(std::span<const ScheduledMatch> matches) {
  std::map<std::string, HostFigures> by_name;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || match.outcome->host.empty()) continue;
    const Outcome& outcome = *match.outcome;
    HostFigures& host = by_name[outcome.host];
    host.host = outcome.host;
    ++host.matches;
    host.decisions += outcome.left.decisions + outcome.right.decisions;
    host.missed += outcome.left.missed + outcome.right.missed;
    host.cycles_per_second += outcome.cycles_per_second;
  }

  std::vector<HostFigures> hosts;
  for (auto& [name, host] : by_name) {
    host.cycles_per_second /= host.matches;
    hosts.push_back(std::move(host));
  }
  mark_outliers(hosts);
  return hosts;
}

TimeSpan time_span(std::span<const ScheduledMatch> matches) {
  TimeSpan span;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome) continue;
    const auto& [started, ended] = std::pair(match.outcome->started, match.outcome->ended);
    if (span.first_start.empty() || (!started.empty() && started < span.first_start)) {
      span.first_start = started;
    }
    span.last_end = std::max(span.last_end, ended);
  }
  return span;
}

std::vector<std::string> versions(std::span<const ScheduledMatch> matches) {
  std::set<std::string> all;
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome) continue;
    if (!match.outcome->version.empty()) all.insert("cls " + match.outcome->version);
    if (!match.outcome->server.empty()) all.insert("server " + match.outcome->server);
  }
  return {all.begin(), all.end()};
}

}  // namespace cls::tournament
