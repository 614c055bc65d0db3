// How many matches at once: given, or found out while playing.
#pragma once

#include <string>
#include <vector>

#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace cls::orchestration::tournament {

/// The first team whose soccer server must be at the ports 6000 to 6002 (`team:DIR` with a `start`,
/// which knows no ports): a machine has room for one such match. Empty when there is none.
std::string team_of_fixed_ports(const TournamentConfig& config);

/// Processors of the match in place `slot` (from 0) of `matches` at once: an equal share of whole
/// cores, each a list of its processors. With fewer cores than matches some share one.
std::vector<int> share_of(const std::vector<std::vector<int>>& cores, int slot, int matches);

/// A number of matches at once that adapts to what matches tell, see local_executor.
class Concurrency {
 public:
  Concurrency(const TournamentConfig& config, int cores);

  int now() const { return now_; }
  bool automatic() const { return automatic_; }

  /// Takes an outcome into account; true when the number changed.
  bool learn(const Outcome& outcome);

 private:
  bool automatic_ = false;
  int now_ = 1;
  int most_ = 1;
  int clean_ = 0;  // matches without a miss since the last change
};

}  // namespace cls::orchestration::tournament
