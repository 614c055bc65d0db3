// Running: dash rate, speeds and distances of player types, and their stamina.
#pragma once

#include <array>
#include <cstddef>

#include "player/world/vocabulary.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::player {

/// Fraction of the dash power that acts in `direction`, degrees relative to the body
/// (docs/spec/simulation-model.md 4.3).
double dash_rate(const soccer::ServerParams& server, double direction);

/// Pushes of a leg per power, with effort and dash power rate 1, in directions from 0 to 180
/// degrees relative to a body along +x.
struct LegPushes {
  static constexpr int kStep = 5;  ///< degrees
  static constexpr std::size_t kCount = 180 / kStep + 1;

  std::array<Vec2, kCount> push{};
  std::array<double, kCount> per_forward{};  ///< power per forward push; 0: none straight sideways

  LegPushes() = default;
  explicit LegPushes(const soccer::ServerParams& server);
};

/// Terminal speed of full dashes with full effort, meters per cycle.
double top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type);

/// Full dashes from rest until the speed is within one centimeter per cycle of top_speed().
int cycles_to_top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type);

/// Cycles a player of that type needs to run `distance` from rest at full power; 0 if `distance` <=
/// 0.
int cycles_to_run(const soccer::ServerParams& server, const soccer::PlayerType& type,
                  double distance);

/// Running distance from rest at full power and effort, meters by cycles.
class ReachTable {
 public:
  static constexpr int kCycles = 60;

  ReachTable() = default;
  ReachTable(const soccer::ServerParams& server, const soccer::PlayerType& type);

  double run(int cycles) const {
    return run_[static_cast<std::size_t>(cycles < 0 ? 0 : cycles > kCycles ? kCycles : cycles)];
  }
  /// Cycles to run `distance`; kCycles + 1 if it exceeds the table.
  int cycles(double distance) const;
  double settled_speed() const { return settled_speed_; }

 private:
  std::array<double, kCycles + 1> run_{};
  double settled_speed_ = 1.0;
};

/// Full dashes with full effort, from rest, in a straight line.
struct FullRun {
  static constexpr int kCycles = 50;

  double top_speed = 0.0;                      ///< meters per cycle
  std::array<double, kCycles + 1> distance{};  ///< meters, by number of dashes
  std::array<double, kCycles + 1> drift{};     ///< per unit of initial velocity, by cycle

  FullRun(const soccer::ServerParams& server, const soccer::PlayerType& type);
};

/// Stamina model of a player (docs/spec/simulation-model.md 5).
struct Stamina {
  double stamina = 0.0;
  double effort = 1.0;
  double recovery = 1.0;
  double capacity = -1.0;

  /// Simulates one cycle in which `cost` is spent.
  void step(const soccer::ServerParams& server, const soccer::PlayerType& type, double cost);
};

}  // namespace cls::player
