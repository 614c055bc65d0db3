// A match on the embedded server with cls players and one coach or trainer; tests provide replies.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"
#include "proxy/coach/coach_agent.h"
#include "simulator/server/lockstep_server.h"

namespace cls::tests {

/// Teams "left" and "right" of eleven players that execute `play`, otherwise stand still. No noise
/// in motion unless `noise`; no time limit unless `half_time` (seconds) is positive. The kick-off
/// is 20 steps after the last client connected.
class CoachedMatch {
 public:
  explicit CoachedMatch(soccer::CoachRole role, soccer::Side side = soccer::Side::kLeft,
                        bool noise = false, int half_time = -1,
                        std::shared_ptr<const player::PlannerParameters> planner = nullptr);

  /// Fills the actions of a player in a step. Empty: stands still.
  std::function<void(const proxy::PlayerAgent&, protos::PlayerActions&)> play;

  /// One step in which `answer` fills the reply to the coach or trainer.
  void step_as_coach(const std::function<void(protos::CoachActions&)>& answer);
  void step_as_trainer(const std::function<void(protos::TrainerActions&)>& answer);
  /// Steps with empty replies.
  void steps(int count);
  /// Steps until the play mode is reached; at most 400 steps.
  void steps_until(soccer::PlayMode mode);
  void set_mode(soccer::PlayMode mode);

  const simulator::World& world() const { return server_->world(); }
  /// Changes the world between two steps.
  void arrange(const std::function<void(simulator::World&)>& change);
  proxy::CoachAgent& coach() { return *coach_; }
  /// The State of the coach in the last step.
  const protos::State& state() const { return state_; }
  proxy::PlayerAgent& player(soccer::Side side, int unum);
  /// The world model in the State of that player in the last step.
  const protos::WorldModel& world_model(soccer::Side side, int unum) const;

 private:
  void join(std::unique_ptr<proxy::PlayerAgent>& player, soccer::Side side, bool goalie);
  void join_coach(soccer::CoachRole role, soccer::Side side,
                  std::shared_ptr<const player::PlannerParameters> planner);
  void run(const std::function<void()>& decide);

  std::unique_ptr<simulator::LockstepServer> server_;
  std::vector<std::unique_ptr<proxy::PlayerAgent>> players_;
  std::vector<protos::State> states_;
  std::unique_ptr<proxy::CoachAgent> coach_;
  protos::State state_;
};

}  // namespace cls::tests
