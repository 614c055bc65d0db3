// The simulator's pitch with one agent on it that knows everything.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/connection/action_report.h"
#include "proxy/planner/action_memory.h"
#include "proxy/world/world_model.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/commands/player_command.h"

namespace cls::tests {

enum class Noise { kNone, kReal };

/// The agent is our number 7 (left team) at the centre, looking along +x; play_on, cycle 100, the
/// ball far away. What it believes is the truth, completed as after a look. The other players stand
/// where they are put.
class KnownPitch {
 public:
  explicit KnownPitch(Noise noise = Noise::kNone, std::uint64_t seed = 1);

  proxy::WorldModel world;
  proxy::ActionMemory memory;
  proxy::ActionReport report;
  std::vector<soccer::PlayerCommand> commands;  ///< of the last cycle

  void place_self(soccer::Vec2 position, double body_deg = 0.0, soccer::Vec2 velocity = {});
  void place_ball(soccer::Vec2 position, soccer::Vec2 velocity = {});
  /// `age` is that of the belief, in cycles; it does not grow.
  void add_teammate(int unum, soccer::Vec2 position, double body_deg = 0.0, int age = 0);
  void add_opponent(int unum, soccer::Vec2 position, double body_deg = 180.0, int age = 0);
  /// The ball is ours in a mode that has a side to start.
  void set_mode(soccer::PlayMode mode);
  /// The same in a shoot-out at the right goal; the mode's side takes the kick.
  void set_shoot_out(soccer::PlayMode mode);
  void set_time(int cycle, int stopped = 0);
  void set_neck(double degrees);
  void set_stamina(double stamina);
  void set_focus(double distance, double degrees);
  void make_goalie();
  /// The agent lies on the ground for so many cycles after a tackle.
  void knock_down(int cycles);

  /// One decision on the reply and one cycle.
  void act(const protos::PlayerActions& reply);
  /// The same with the actions that `fill` puts into a reply that forbids what the proxy does by
  /// itself.
  void act(const std::function<void(protos::PlayerActions&)>& fill);
  /// The same until `done` says so or `cycles` are over; the number of cycles it took.
  int act_until(int cycles, const std::function<void(protos::PlayerActions&)>& fill,
                const std::function<bool()>& done);
  /// Cycles without a command.
  void roll(int cycles);

  /// Inside the cone that the next see message shows.
  bool sees(soccer::Vec2 point) const;
  soccer::Vec2 focus_point() const;
  bool touched_ball() const { return self().contacts.ball; }
  const proxy::ActionCounts& counts(protos::PlayerAction::ActionCase member) const;
  /// The command of that kind in the last cycle; null when there was none.
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
  void add(proxy::PlayerList& list, soccer::Side side, int unum, soccer::Vec2 position,
           double body_deg, int age);
  void believe();
  void believe_self();
  void believe_player(proxy::PlayerState& player) const;

  simulator::World truth_;
  simulator::Events events_;
};

}  // namespace cls::tests
