// Who plays the players that are not agents.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "soccer/random.h"

namespace cls::training {

enum class Driver : unsigned char {
  kHold,      ///< stands still
  kScripted,  ///< plays by geometry, from the exact world
  kMock,      ///< the simple team of the mock Playmaker
  kPlanner,   ///< as the mock Playmaker's behavior "planner": the skills and the planner of cls
};

/// By value.
constexpr std::array<std::string_view, 4> kDriverNames = {"hold", "scripted", "mock", "planner"};

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

}  // namespace cls::training
