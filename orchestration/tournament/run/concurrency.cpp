// Down at a miss, up after a clean round.
#include "orchestration/tournament/run/concurrency.h"

#include <algorithm>
#include <filesystem>

#include "orchestration/match/options/endpoint.h"

namespace cls::orchestration::tournament {
namespace {

// A team against the clock needs room beside it; in lockstep nothing is lost by waiting.
constexpr int kCoresForRealTime = 4;

bool waits_for_everybody(const TournamentConfig& config) {
  return config.mode.empty() || config.mode == "lockstep";
}

}  // namespace

std::string team_of_fixed_ports(const TournamentConfig& config) {
  for (const TeamEntry& team : config.teams) {
    const auto endpoint = match::parse_endpoint(team.endpoint);
    if (!endpoint || endpoint->kind != match::Endpoint::Kind::kTeam) continue;
    std::error_code code;
    if (std::filesystem::exists(config.folder / endpoint->path / "start", code)) return team.name;
  }
  return "";
}

std::vector<int> share_of(const std::vector<std::vector<int>>& cores, int slot, int matches) {
  const std::size_t share =
      std::max<std::size_t>(1, cores.size() / static_cast<std::size_t>(std::max(1, matches)));
  std::vector<int> processors;
  for (std::size_t i = 0; i < share && !cores.empty(); ++i) {
    const auto& core = cores[(static_cast<std::size_t>(slot) * share + i) % cores.size()];
    processors.insert(processors.end(), core.begin(), core.end());
  }
  return processors;
}

Concurrency::Concurrency(const TournamentConfig& config, int cores)
    : automatic_(config.concurrency == 0) {
  if (!team_of_fixed_ports(config).empty()) {
    automatic_ = false;
    return;
  }
  if (!automatic_) {
    now_ = most_ = config.concurrency;
    return;
  }
  most_ = std::max(1, cores);
  now_ = waits_for_everybody(config) ? most_ : std::max(1, cores / kCoresForRealTime);
}

bool Concurrency::learn(const Outcome& outcome) {
  if (!automatic_ || !outcome.played()) return false;
  const bool missed =
      outcome.left.late + outcome.left.missed + outcome.right.late + outcome.right.missed > 0;
  const int before = now_;
  if (missed) {
    // Not tried again: what was too much once would be so now and then.
    now_ = most_ = std::max(1, now_ - 1);
    clean_ = 0;
  } else if (++clean_ >= now_ && now_ < most_) {
    ++now_;
    clean_ = 0;
  }
  return now_ != before;
}

}  // namespace cls::orchestration::tournament
