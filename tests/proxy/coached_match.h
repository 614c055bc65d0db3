// A match on the embedded server with our players and one coach or trainer, whose answers a test
// gives.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"
#include "proxy/coach/coach_agent.h"
#include "simulator/server/lockstep_server.h"

namespace cls::tests {

/// Teams "left" and "right" of eleven, who do what `play` says and else stand; no noise in motion
/// unless `noise`. Without a time limit unless `half_time` (seconds) is one; the kick-off comes 20
/// steps after the last one joined.
class CoachedMatch {
 public:
  explicit CoachedMatch(soccer::CoachRole role, soccer::Side side = soccer::Side::kLeft,
                        bool noise = false, int half_time = -1);

  /// What a player does in a step; his State is at hand. Nothing: stands.
  std::function<void(const proxy::PlayerAgent&, protos::PlayerActions&)> play;

  /// One step in which the coach or trainer answers with what `answer` fills in.
  void step_as_coach(const std::function<void(protos::CoachActions&)>& answer);
  void step_as_trainer(const std::function<void(protos::TrainerActions&)>& answer);
  /// Steps without wishes.
  void steps(int count);
  /// The same until the mode is that; at most 400.
  void steps_until(soccer::PlayMode mode);
  void set_mode(soccer::PlayMode mode);

  const simulator::World& world() const { return server_->world(); }
  /// Changes the world by hand, between two steps.
  void arrange(const std::function<void(simulator::World&)>& change);
  proxy::CoachAgent& coach() { return *coach_; }
  /// What the coach was asked in the last step.
  const protos::State& state() const { return state_; }
  proxy::PlayerAgent& player(soccer::Side side, int unum);
  /// What that player's Playmaker was asked in the last step.
  const protos::WorldModel& beliefs(soccer::Side side, int unum) const;

 private:
  void join(std::unique_ptr<proxy::PlayerAgent>& player, soccer::Side side, bool goalie);
  void join_coach(soccer::CoachRole role, soccer::Side side);
  void run(const std::function<void()>& decide);

  std::unique_ptr<simulator::LockstepServer> server_;
  std::vector<std::unique_ptr<proxy::PlayerAgent>> players_;
  std::vector<protos::State> beliefs_;
  std::unique_ptr<proxy::CoachAgent> coach_;
  protos::State state_;
};

}  // namespace cls::tests
