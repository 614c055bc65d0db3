// From a world model to features, scores and an option.
#include "training/policy/policy_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"
#include "soccer/math.h"
#include "soccer/random.h"
#include "training/npc/driver.h"

namespace cls::training {
namespace {

using player::OptionTable;

/// The score of an option that is never chosen.
constexpr float kHopeless = -1000.0F;

/// kAutoOption is what other policies and players do without choosing.
bool may_choose(const OptionTable& table, int id) {
  return id != player::kAutoOption && table.legal[base::index(id)];
}

}  // namespace

int best_option(const OptionTable& table, const float* scores) {
  int best = player::kAutoOption;
  for (int id = 0; id < player::kOptionCount; ++id) {
    if (!may_choose(table, id)) continue;
    if (best == player::kAutoOption || scores[id] > scores[best]) best = id;
  }
  return best;
}

std::vector<player::WeighedOption> weigh_options(const player::WorldModel& world,
                                                 const OptionTable& table, const float* scores,
                                                 int chosen) {
  std::vector<player::WeighedOption> weighed;
  double sum = 0.0;
  for (int id = 0; id < player::kOptionCount; ++id) {
    if (!may_choose(table, id)) continue;
    const double above = static_cast<double>(scores[id]) - static_cast<double>(scores[chosen]);
    weighed.push_back({id, soccer::math::exp(above), id == chosen, aim_of(world, table, id)});
    sum += weighed.back().share;
  }
  // Scores of a foreign network may be infinite: the choice stays.
  const bool finite = sum > 0.0 && std::isfinite(sum);
  for (player::WeighedOption& option : weighed) {
    option.share = finite ? option.share / sum : option.chosen ? 1.0 : 0.0;
  }
  return weighed;
}

PolicyPlayer::PolicyPlayer(std::shared_ptr<const Policy> policy) : policy_(std::move(policy)) {
  if (policy_->features != nullptr) features_.emplace(*policy_->features);
  memory_.resize(base::index(policy_->network.memory()));
}

bool PolicyPlayer::decides() const {
  if (table_.choice == OptionTable::Choice::kWithBall) return true;
  return table_.choice == OptionTable::Choice::kWithoutBall &&
         policy_->decides == PolicyDecides::kAll;
}

void PolicyPlayer::play(player::ActionContext& context) {
  find_options(context, table_);
  int chosen = player::kAutoOption;
  if (decides()) {
    chosen = choose(context);
    if (chosen >= 0 && may_choose(table_, chosen)) {
      context.choice.weighed = weigh_options(context.world, table_, scores_.data(), chosen);
    }
  }
  play_option(context, table_, chosen);
}

int PolicyPlayer::choose(const player::ActionContext& context) {
  switch (policy_->kind) {
    case PolicyKind::kPlanner:
      return choose_as_planner(context.world);
    case PolicyKind::kRandom:
      return choose_randomly(context.world);
    case PolicyKind::kNetwork:
      break;
  }
  return choose_by_network(context.world);
}

int PolicyPlayer::choose_by_network(const player::WorldModel& world) {
  const float* features = features_->of(world, table_).data();
  const float* scores = policy_->network.run(features, memory_.data(), workspace_);
  std::copy_n(scores, scores_.size(), scores_.begin());
  return best_option(table_, scores);
}

int PolicyPlayer::choose_as_planner(const player::WorldModel& world) {
  const int chosen = planner_option(world, table_, planner_options());
  scores_.fill(kHopeless);
  if (chosen >= 0) scores_[base::index(chosen)] = 0.0F;
  return chosen;
}

int PolicyPlayer::choose_randomly(const player::WorldModel& world) {
  scores_.fill(0.0F);
  const player::GameTime now = world.game.time;
  soccer::RandomStream stream(static_cast<std::uint64_t>(world.unum), "random policy",
                              static_cast<std::uint64_t>(now.cycle),
                              static_cast<std::uint64_t>(now.stopped));
  base::FixedList<int, player::kOptionCount> legal;
  for (int id = 0; id < player::kOptionCount; ++id) {
    if (may_choose(table_, id)) legal.push_back(id);
  }
  return legal.empty() ? player::kAutoOption
                       : legal[base::index(stream.integer(static_cast<int>(legal.size())))];
}

}  // namespace cls::training
