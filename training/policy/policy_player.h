// A player of a match that follows a policy.
#pragma once

#include <memory>
#include <vector>

#include "player/options/options.h"
#include "training/policy/policy.h"
#include "training/scene/cast.h"

namespace cls::training {

/// One for each player. The same world models in the same order give the same decisions.
class PolicyPlayer {
 public:
  explicit PolicyPlayer(std::shared_ptr<const Policy> policy);

  /// One decision between begin_decision() and finish_decision().
  void play(player::ActionContext& context);

 private:
  bool decides() const;
  int choose(const player::ActionContext& context);
  int choose_by_network(const player::WorldModel& world);
  int choose_randomly(const player::WorldModel& world) const;

  std::shared_ptr<const Policy> policy_;
  player::OptionTable table_;
  Cast everybody_;
  Scene scene_;
  std::vector<float> features_;
  std::vector<float> memory_;
  Network::Workspace workspace_;
};

/// The legal option of the highest score; of equal ones the first.
int best_option(const player::OptionTable& table, const float* scores);

}  // namespace cls::training
