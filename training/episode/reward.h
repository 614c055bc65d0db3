// Rewards: a sum of named terms with weights.
#pragma once

#include <array>
#include <string_view>

#include "training/tasks/task.h"

namespace cls::training {

struct RewardTerm {
  std::string_view name;
  double weight;  ///< default: the sparse reward
  std::string_view unit;
  double low;  ///< bounds of a cycle
  double high;
  std::string_view summary;
};

constexpr std::size_t kRewardTerms = 11;
/// A change of a term's value needs a new version.
constexpr int kRewardVersion = 1;
const std::array<RewardTerm, kRewardTerms>& reward_terms();

/// Unweighted terms of one step for one player, from the view of its team.
using RewardValues = std::array<double, kRewardTerms>;

/// Values that rewards compare between steps. Part of an episode.
struct RewardMemory {
  double ball_to_right_goal = 0.0;  ///< meters from the ball to the goal that the left attacks
  int rings = 0;                    ///< checkpoints of the left team so far
  std::array<double, soccer::kPlayersOnPitch> to_ball{};  ///< meters, by slot
  std::array<bool, soccer::kPlayersOnPitch> touched{};    ///< has been able to kick
};

/// Start of an episode.
void begin_rewards(const simulator::World& world, const Cast& cast, RewardMemory& memory);

/// Adds the terms of one cycle to `sums`, by agent of the cast in its order. `before` is the score
/// before the cycle.
void add_rewards(const simulator::World& world, const Cast& cast, Status status,
                 const TaskMemory& task, std::array<int, 2> before, RewardMemory& memory,
                 std::array<RewardValues, soccer::kPlayersOnPitch>& sums);

/// Adds the effort of a dash.
void add_effort(double power, RewardValues& sum);

}  // namespace cls::training
