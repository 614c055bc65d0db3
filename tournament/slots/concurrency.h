// Number of parallel matches: configured, or adapted while playing.
#pragma once

#include <string>
#include <vector>

#include "league/matches/fixture.h"
#include "tournament/config/config.h"
#include "tournament/config/host_list.h"

namespace cls::tournament {

/// The first team that needs its soccer server at the ports 6000 to 6002 (`team:DIR` with a `start`
/// without port arguments): a host can run one such match. Empty when there is none.
std::string fixed_port_team(const TournamentConfig& config);

/// The hosts of the executor "hosts" with the matches that each plays in parallel.
std::vector<HostSlots> host_slots(const TournamentConfig& config);

/// CPUs of slot `slot` (from 0) of `matches` parallel matches: an equal share of whole cores, each
/// given as the list of its CPUs. With fewer cores than matches some slots share one.
std::vector<int> cpus_of_slot(const std::vector<std::vector<int>>& cores, int slot, int matches);

/// A number of parallel matches that adapts to missed decisions, see local_executor.
class Concurrency {
 public:
  Concurrency(const TournamentConfig& config, int cores);

  int current() const { return current_; }
  bool automatic() const { return automatic_; }

  /// Adapts to the outcome of a match; true when the number changed.
  bool adapt(const Outcome& outcome);

 private:
  bool automatic_ = false;
  int current_ = 1;
  int max_ = 1;
  int clean_ = 0;  // matches without a miss since the last change
};

}  // namespace cls::tournament
