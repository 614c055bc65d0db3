// How fast players of a type run, as a table.
#pragma once

#include <array>

#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

/// Metres run from rest at full power and effort, by cycles.
class ReachTable {
 public:
  static constexpr int kCycles = 60;

  ReachTable() = default;
  ReachTable(const soccer::ServerParams& server, const soccer::PlayerType& type);

  double run(int cycles) const {
    return run_[static_cast<std::size_t>(cycles < 0 ? 0 : cycles > kCycles ? kCycles : cycles)];
  }
  /// Cycles to run that far; kCycles + 1 when it takes longer than the table is long.
  int cycles(double distance) const;
  double settled_speed() const { return settled_speed_; }

 private:
  std::array<double, kCycles + 1> run_{};
  double settled_speed_ = 1.0;
};

}  // namespace cls::proxy
