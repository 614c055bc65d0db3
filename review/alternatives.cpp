// Candidates from the planner's tree and from skills.
#include "review/alternatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "player/ball_skills/ball_skills.h"
#include "player/planner/plan_execution.h"
#include "player/world/places.h"

namespace cls::review {
namespace {

using player::ActionContext;
using player::Plan;
using player::PlanAction;
using player::PlanCategory;
using player::PlanTag;

constexpr double kShotRange = 32.0;  // meters
constexpr int kKicks = 3;            // of a sequence of kicks, at most
constexpr int kHoldCycles = 5;
constexpr int kAction = 1;  // node of Alternative::plan

std::string group_of(const PlanAction& action) {
  switch (action.category) {
    case PlanCategory::kPass:
      if (action.tag == PlanTag::kStrictThrough) return "through pass";
      return action.tag == PlanTag::kCross ? "cross" : "pass";
    case PlanCategory::kDribble:
      return action.tag == PlanTag::kSelfPass ? "long dribble" : "dribble";
    case PlanCategory::kShoot:
      return "shot";
    default:
      return "hold";
  }
}

// First actions of the tree, one for each kind and receiver, with the best value below them.
std::vector<std::pair<double, int>> best_first_actions(const Plan& plan) {
  std::map<std::pair<std::string, int>, std::pair<double, int>> best;
  for (int node = 1; node < static_cast<int>(plan.nodes.size()); ++node) {
    const int first = plan.first_of(node);
    const PlanAction& action = plan.at(first).action;
    if (action.category == PlanCategory::kHold) continue;
    const auto [place, is_new] =
        best.try_emplace({group_of(action), action.target}, plan.at(node).value, first);
    if (!is_new) place->second = std::max(place->second, {plan.at(node).value, first});
  }

  std::vector<std::pair<double, int>> actions;
  for (const auto& [key, action] : best) actions.push_back(action);
  std::ranges::stable_sort(actions, std::ranges::greater{}, &std::pair<double, int>::first);
  return actions;
}

Alternative planned(const Plan& plan, int node) {
  const PlanAction& action = plan.at(node).action;
  Alternative result;
  result.kind = AlternativeKind::kPlanned;
  result.plan.nodes = {plan.at(0), plan.at(node)};
  result.group = group_of(action);
  result.text = action.category == PlanCategory::kPass
                    ? fmt::format("{} to {}", result.group, action.target)
                    : result.group;
  result.target = action.target_point;
  result.planned = plan.first_of(plan.best) == node;
  return result;
}

Alternative skill(AlternativeKind kind, std::string name, soccer::Vec2 target) {
  Alternative result;
  result.kind = kind;
  result.group = result.text = std::move(name);
  result.target = target;
  return result;
}

soccer::Vec2 shot_target(const player::WorldModel& world) {
  const player::Gap gap = player::widest_gap(world);
  return gap.degrees > 0.0 ? gap.target : player::kOpponentGoal;
}

void execute(const Alternative& alternative, ActionContext& context) {
  switch (alternative.kind) {
    case AlternativeKind::kPlanned:
      execute_plan_or_hold(context, alternative.plan, kAction);
      return;
    case AlternativeKind::kHold:
      hold_ball(context.world, context.slots, false, {});
      return;
    case AlternativeKind::kClear:
      kick_outlet(context);
      return;
    case AlternativeKind::kShoot: {
      const double speed = context.world.server().ball_speed_max;
      const soccer::Vec2 target = shot_target(context.world);
      context.neck = {player::NeckPlan::Kind::kPoint, target};
      smart_kick(context.world, context.slots, target, speed, 0.9 * speed, kKicks);
      return;
    }
  }
}

}  // namespace

std::vector<Alternative> alternatives_of(const training::MatchPlayer& player, std::size_t most) {
  training::MatchPlayer thinker = player;
  Plan plan;
  training::decide_with(
      [&](ActionContext& context) {
        plan = plan_of_decision(context, training::planner_options());
      },
      thinker);

  const player::WorldModel& world = player.senses.world;
  std::vector<Alternative> skills;
  skills.push_back(skill(AlternativeKind::kHold, "hold", world.ball.position));
  skills.push_back(skill(AlternativeKind::kClear, "clear", world.ball.position));
  skills.front().planned = plan.first_of(plan.best) == 0;
  if (distance(world.ball.position, player::kOpponentGoal) < kShotRange) {
    skills.push_back(skill(AlternativeKind::kShoot, "shot", shot_target(world)));
  }

  std::vector<Alternative> all;
  for (const auto& [value, node] : best_first_actions(plan)) {
    if (all.size() + skills.size() >= most) break;
    all.push_back(planned(plan, node));
  }
  std::ranges::move(skills, std::back_inserter(all));
  return all;
}

int longest_cycles(const Alternative& alternative) {
  if (alternative.kind == AlternativeKind::kHold) return kHoldCycles;
  if (alternative.kind != AlternativeKind::kPlanned) return kKicks;
  // A dribble leaves an intention, with which the player goes on.
  const PlanAction& action = alternative.plan.at(kAction).action;
  return action.category == PlanCategory::kDribble ? 1 : kKicks;
}

void carry_out(const Alternative& alternative, training::MatchPlayer& player) {
  training::decide_with([&](ActionContext& context) { execute(alternative, context); }, player);
}

}  // namespace cls::review
