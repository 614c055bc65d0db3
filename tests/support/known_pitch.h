// A simulator world with one agent that has perfect knowledge.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "player/planner/action_context.h"
#include "player/world/world_model.h"
#include "proto/playmaker.pb.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/commands/player_command.h"

namespace cls::tests {

/// All kinds of actions of the planner.
void allow_everything(protos::HeliosOffensivePlanner& planner);

/// Disables all automatic behavior around the actions of `reply`.
void disable_automatic_behavior(protos::PlayerActions& reply);

enum class Noise { kNone, kReal };

/// The agent is number 7 of the left team at the center, facing +x; play_on, cycle 100, the ball
/// far away. Its estimates equal the ground truth, as right after a see message. Other players are
/// added by the test.
class KnownPitch {
 public:
  explicit KnownPitch(Noise noise = Noise::kNone, std::uint64_t seed = 1);

  player::WorldModel world;
  player::ActionMemory memory;
  player::ActionReport report;
  std::vector<soccer::PlayerCommand> commands;  ///< of the last cycle

  void place_self(soccer::Vec2 position, double body_deg = 0.0, soccer::Vec2 velocity = {});
  void place_ball(soccer::Vec2 position, soccer::Vec2 velocity = {});
  /// `age` of the estimate in cycles; it does not grow.
  void add_teammate(int unum, soccer::Vec2 position, double body_deg = 0.0, int age = 0);
  void add_opponent(int unum, soccer::Vec2 position, double body_deg = 180.0, int age = 0);
  /// Sets the mode; the left team has the kick-off.
  void set_mode(soccer::PlayMode mode);
  /// Sets a shoot-out mode at the right goal; the mode's side takes the kick.
  void set_shoot_out(soccer::PlayMode mode);
  void set_time(int cycle, int stopped = 0);
  /// The agent plays with this value of a planner parameter from now on.
  void set_parameter(std::string_view name, double value);
  void set_neck(double degrees);
  void set_stamina(double stamina);
  void set_focus(double distance, double degrees);
  void make_goalie();
  /// Puts the agent on the ground for `cycles` after a tackle.
  void knock_down(int cycles);

  /// Executes one decision and one cycle.
  void act(const protos::PlayerActions& reply);
  /// Acts with the actions that `fill` adds to a reply with all automatic behavior disabled.
  void act(const std::function<void(protos::PlayerActions&)>& fill);
  /// Repeats until `done` returns true, at most `cycles` times; returns the number of cycles.
  int act_until(int cycles, const std::function<void(protos::PlayerActions&)>& fill,
                const std::function<bool()>& done);
  /// Simulates cycles without commands.
  void roll(int cycles);

  /// True if the point is in the view cone of the next see message.
  bool sees(soccer::Vec2 point) const;
  soccer::Vec2 focus_point() const;
  bool touched_ball() const { return self().contacts.ball; }
  const player::ActionCounts& counts(protos::PlayerAction::ActionCase member) const;
  /// Command of that type in the last cycle; null if none.
  template <typename Command>
  const Command* sent() const {
    for (const soccer::PlayerCommand& command : commands) {
      if (const auto* found = std::get_if<Command>(&command)) return found;
    }
    return nullptr;
  }

 private:
  simulator::Player& self();
  const simulator::Player& self() const;
  void step();
  void add(player::PlayerList& list, soccer::Side side, int unum, soccer::Vec2 position,
           double body_deg, int age);
  void update_world();
  void update_self();
  void update_player(player::PlayerState& player) const;

  simulator::World truth_;
  simulator::Events events_;
};

}  // namespace cls::tests
