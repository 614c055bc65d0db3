// Drivers of the players that are not agents; some perceive and decide as agents do.
#pragma once

#include <functional>
#include <vector>

#include "base/text/enum_names.h"
#include "player/planner/action_context.h"
#include "soccer/random.h"
#include "training/senses/perceiver.h"

namespace cls::training {

enum class Driver : unsigned char {
  kHold,      ///< stands still
  kScripted,  ///< plays by geometry, from the exact world
  kMock,      ///< the simple team of the mock Playmaker
  kPlanner,   ///< as the mock Playmaker's behavior "planner": the skills and the planner of cls
};

constexpr auto kDriverNames = base::enum_names<Driver>("hold", "scripted", "mock", "planner");

/// True for drivers of players that perceive and decide as the agents of a match do.
constexpr bool perceives(Driver driver) {
  return driver == Driver::kMock || driver == Driver::kPlanner;
}

struct DriverShare {
  Driver driver = Driver::kScripted;
  double weight = 1.0;
};

/// Drivers of a team, one of which is drawn for each episode; empty: there are no such players.
using DriverPool = std::vector<DriverShare>;

/// Index of a driver, drawn by weight; -1 for an empty pool.
int draw_driver(const DriverPool& pool, soccer::RandomStream& random);

/// A player that perceives and decides as the agents of a match do. A copyable value.
struct MatchPlayer {
  Perceiver senses;
  player::ActionMemory memory;
};

/// Decides from the completed world model: fills player.senses.commands with what such an agent of
/// a match sends. The driver must be one that perceives.
void decide(Driver driver, MatchPlayer& player);

/// The options of Driver::kPlanner, and of the mock Playmaker's behavior "planner".
player::PlannerOptions planner_options();

/// Decides by `choose`, which fills the slots of the context, instead of a driver.
void decide_with(const std::function<void(player::ActionContext&)>& choose, Perceiver& senses,
                 player::ActionMemory& memory);
inline void decide_with(const std::function<void(player::ActionContext&)>& choose,
                        MatchPlayer& player) {
  decide_with(choose, player.senses, player.memory);
}

/// One decision of a player of the mock Playmaker's simple team, between player::begin_decision()
/// and player::finish_decision().
void play_as_simple_team(player::ActionContext& context);

}  // namespace cls::training
