// A world for tests of single commands and steps.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulator/actions/actions.h"
#include "simulator/actions/trainer.h"
#include "simulator/referee/referee.h"
#include "simulator/step.h"
#include "simulator/world/event.h"
#include "simulator/world/roster.h"
#include "simulator/world/world.h"

namespace cls::tests {

using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;

using Calls = std::vector<std::string>;
using Change = std::function<void(soccer::ServerParams&)>;

/// Default parameters without noise; `change` may set others.
soccer::ServerParams noise_free_params(const Change& change = {});

simulator::World make_match(const soccer::ServerParams& server,
                            const soccer::PlayerParams& player = {}, std::uint64_t seed = 1);

/// A world without noise, initially without players.
class Stage {
 public:
  explicit Stage(const soccer::ServerParams& server = noise_free_params());
  explicit Stage(const Change& change) : Stage(noise_free_params(change)) {}

  /// Adds the next player of a side, at rest, with body angle 0.
  simulator::Player& add(Side side, Vec2 position, bool goalie = false);
  simulator::Player& place(simulator::Player& player, Vec2 position, Vec2 velocity = {});
  void place_ball(Vec2 position, Vec2 velocity = {});
  void set_mode(PlayMode mode);

  /// Executes the commands of a datagram; returns false on a syntax error.
  bool command(const simulator::Player& player, const std::string& datagram);

  /// Runs complete steps.
  void step(int count = 1);
  /// Steps until the mode changes; returns the number of steps.
  int step_until_mode_changes(int max_steps = 1000);

  /// Removes and returns the referee messages so far, as "TIME MESSAGE".
  Calls take_calls();

  simulator::World world;
  simulator::Events events;
  std::optional<soccer::ServerReply> reply;  ///< to the last command
};

/// Tests on the default stage.
class OnStage : public testing::Test {
 protected:
  Stage stage;
};

/// Both coordinates within `tolerance`.
void expect_near(Vec2 actual, Vec2 expected, double tolerance = 1e-6);

double body_degrees(const simulator::Player& player);

}  // namespace cls::tests
