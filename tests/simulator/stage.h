// A world set up by hand: who stands where, one command, one step.
#pragma once

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

/// Parameters without any noise, default otherwise.
soccer::ServerParams quiet_params();

simulator::World make_match(const soccer::ServerParams& server,
                            const soccer::PlayerParams& player = {}, std::uint64_t seed = 1);

/// A world without noise and without players until they are added.
class Stage {
 public:
  explicit Stage(const soccer::ServerParams& server = quiet_params());

  /// The next player of a side, standing there at rest, with body 0.
  simulator::Player& add(Side side, Vec2 position, bool goalie = false);
  simulator::Player& place(simulator::Player& player, Vec2 position, Vec2 velocity = {});
  void place_ball(Vec2 position, Vec2 velocity = {});
  void set_mode(PlayMode mode);

  /// Runs a datagram's commands; false if the grammar refuses it.
  bool command(const simulator::Player& player, const std::string& datagram);

  /// One step with the frame's end, or several.
  void step(int count = 1);
  /// Steps until the mode is another than now; how many that took.
  int step_until_mode_changes(int most = 1000);

  /// The referee's words since the last call, as "TIME word".
  std::vector<std::string> words();

  simulator::World world;
  simulator::Events events;
  std::optional<soccer::ServerReply> reply;  ///< to the last command
};

/// Both coordinates within `tolerance`.
void expect_near(Vec2 actual, Vec2 expected, double tolerance = 1e-6);

double body_degrees(const simulator::Player& player);

}  // namespace cls::tests
