// A player of a match that follows a policy.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "player/options/options.h"
#include "training/policy/player_features.h"
#include "training/policy/policy.h"

namespace cls::training {

/// One for each player. The same world models in the same order give the same decisions.
class PolicyPlayer {
 public:
  explicit PolicyPlayer(std::shared_ptr<const Policy> policy);

  /// One decision between begin_decision() and finish_decision().
  void play(player::ActionContext& context);

 private:
  bool decides() const;
  // The option, and a score for each in scores_.
  int choose(const player::ActionContext& context);
  int choose_by_network(const player::WorldModel& world);
  int choose_as_planner(const player::WorldModel& world);
  int choose_randomly(const player::WorldModel& world);

  std::shared_ptr<const Policy> policy_;
  player::OptionTable table_;
  std::optional<PlayerFeatures> features_;  ///< of a network
  std::array<float, player::kOptionCount> scores_{};
  std::vector<float> memory_;
  Network::Workspace workspace_;
};

/// All legal options with the probabilities that scores mean: the softmax over them. `chosen` is
/// one of them.
std::vector<player::WeighedOption> weigh_options(const player::WorldModel& world,
                                                 const player::OptionTable& table,
                                                 const float* scores, int chosen);

/// The legal option of the highest score; of equal ones the first.
int best_option(const player::OptionTable& table, const float* scores);

}  // namespace cls::training
