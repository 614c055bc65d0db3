// Decreases after a miss, increases after a clean round.
#include "tournament/slots/concurrency.h"

#include <algorithm>
#include <filesystem>

#include "match/terms/endpoint.h"
#include "match/terms/match_options.h"

namespace cls::tournament {
namespace {

// Matches in real time need spare cores; in lockstep the server waits.
constexpr int kCoresPerRealTimeMatch = 4;

bool is_lockstep(const TournamentConfig& config) {
  const auto mode = match_options(config.conditions).mode;
  return !mode || *mode == match::MatchMode::kLockstep;
}

}  // namespace

std::string fixed_port_team(const TournamentConfig& config) {
  for (const TeamEntry& team : config.competition.teams) {
    const auto endpoint = match::parse_endpoint(team.endpoint);
    if (!endpoint || endpoint->kind != match::Endpoint::Kind::kTeam) continue;
    std::error_code code;
    if (!endpoint->parts.empty()) return team.name;  // mixed teams have start scripts
    if (std::filesystem::exists(config.execution.folder / endpoint->path / "start", code))
      return team.name;
  }
  return "";
}

std::vector<HostSlots> host_slots(const TournamentConfig& config) {
  auto hosts = parse_hosts(config.execution.hosts);
  if (!hosts) return {};
  if (fixed_port_team(config).empty()) return *std::move(hosts);
  for (HostSlots& host : *hosts) host.slots = 1;
  return *std::move(hosts);
}

std::vector<int> cpus_of_slot(const std::vector<std::vector<int>>& cores, int slot, int matches) {
  const std::size_t share =
      std::max<std::size_t>(1, cores.size() / base::index(std::max(1, matches)));
  std::vector<int> cpus;
  for (std::size_t i = 0; i < share && !cores.empty(); ++i) {
    const auto& core = cores[(base::index(slot) * share + i) % cores.size()];
    cpus.insert(cpus.end(), core.begin(), core.end());
  }
  return cpus;
}

Concurrency::Concurrency(const TournamentConfig& config, int cores)
    : automatic_(config.execution.concurrency == 0) {
  if (config.execution.executor == ExecutorKind::kHosts) {
    automatic_ = false;
    current_ = 0;
    for (const HostSlots& host : host_slots(config)) current_ += host.slots;
    return;
  }
  if (!fixed_port_team(config).empty()) {
    automatic_ = false;
    return;
  }
  if (!automatic_) {
    current_ = max_ = config.execution.concurrency;
    return;
  }
  max_ = std::max(1, cores);
  current_ = is_lockstep(config) ? max_ : std::max(1, cores / kCoresPerRealTimeMatch);
}

bool Concurrency::adapt(const Outcome& outcome) {
  if (!automatic_ || !outcome.played()) return false;

  const bool missed =
      outcome.left.late + outcome.left.missed + outcome.right.late + outcome.right.missed > 0;

  const int before = current_;
  if (missed) {
    // Lowers the maximum for good: a number that was too high once would be so again.
    current_ = max_ = std::max(1, current_ - 1);
    clean_ = 0;
  } else if (++clean_ >= current_ && current_ < max_) {
    ++current_;
    clean_ = 0;
  }
  return current_ != before;
}

}  // namespace cls::tournament
