// Which team gets a ball that the agent tackles away.
#pragma once

#include "base/fixed_list.h"
#include "player/world/running.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Cycles until a team gets the ball; as many for both if it leaves the pitch before.
struct RaceResult {
  int ours = 0;
  int theirs = 0;
};

/// The players who may run for the ball after a tackle of the agent, which lies on the ground
/// itself. The world model must outlive it.
class BallRace {
 public:
  /// `foul`: intentional, so that the opponent with the ball cannot move for some cycles.
  BallRace(const WorldModel& world, bool foul);

  RaceResult run(soccer::Vec2 velocity) const;

 private:
  struct Runner {
    soccer::Vec2 from;
    double control = 0.0;  ///< distance within which it kicks, meters
    int delay = 0;         ///< cycles until it can run
    bool ours = false;
    std::size_t type = 0;  ///< index into types_
  };

  void add(const soccer::PlayerType& type, Runner runner);
  void add_others(const PlayerList& players, bool ours, bool foul);
  bool gets_ball(const Runner& runner, soccer::Vec2 ball, int cycle) const;

  const WorldModel& world_;
  base::FixedList<const soccer::PlayerType*, 22> types_;
  base::FixedList<ReachTable, 22> reach_;  ///< by index into types_
  base::FixedList<Runner, 22> runners_;
};

}  // namespace cls::player
