// Computes the field value, then applies the effectors in the order of the interface.
#include "proxy/planner/playmaker_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/index.h"
#include "player/planner/planner.h"
#include "proto/playmaker.pb.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

/// Cell value of a matrix that covers the pitch, relative to its minimum.
double matrix_value(const protos::MatrixFieldEvaluator& matrix, Vec2 ball) {
  const auto cell = [](double from_edge, double size, int count) {
    const double index = std::floor(from_edge / (size / count));
    return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count - 1)));
  };

  double least = std::numeric_limits<double>::max();
  for (const auto& column : matrix.evals()) {
    for (const float value : column.evals()) least = std::min(least, static_cast<double>(value));
  }

  if (matrix.evals_size() == 0) return 0.0;
  const auto& column =
      matrix.evals(cell(ball.x + soccer::kHalfLength, soccer::kPitchLength, matrix.evals_size()));
  if (column.evals_size() == 0) return 0.0;
  return column.evals(cell(ball.y + soccer::kHalfWidth, soccer::kPitchWidth, column.evals_size())) -
         least;
}

double field_value(const player::PlannerField& field, const player::PlanNode& state,
                   const protos::PlannerFieldEvaluator& evaluation) {
  double value = 0.0;
  if (evaluation.has_helios_field_evaluator()) {
    const auto& helios = evaluation.helios_field_evaluator();
    player::FieldWeights weights;
    weights.x = std::max(0.0F, helios.x_coefficient());
    weights.goal_distance = std::max(0.0F, helios.ball_dist_to_goal_coefficient());
    weights.goal_radius = std::max(0.0F, helios.effective_max_ball_dist_to_goal());
    value += ball_value(field, state, weights);
  }

  if (evaluation.has_matrix_field_evaluator()) {
    value += matrix_value(evaluation.matrix_field_evaluator(), state.ball);
  }

  return value;
}

double kind_factor(const protos::ActionTypeEffector& factors, player::PlanTag first) {
  using player::PlanTag;
  for (const auto& [tag, factor] : {std::pair{PlanTag::kStrictDirect, factors.direct_pass()},
                                    {PlanTag::kStrictLead, factors.lead_pass()},
                                    {PlanTag::kStrictThrough, factors.through_pass()},
                                    {PlanTag::kCross, factors.cross()},
                                    {PlanTag::kShortDribble, factors.short_dribble()},
                                    {PlanTag::kSelfPass, factors.long_dribble()},
                                    {PlanTag::kHold, factors.hold()}}) {
    if (tag == first) return std::max(0.0, static_cast<double>(factor));
  }
  return 1.0;
}

/// Entry for the integer part of `at`, 0 beyond the list. Positive entries count as zero; the list
/// is shifted so that the worst entry gives zero.
template <typename List>
double listed_effect(const List& list, double at) {
  if (list.empty()) return 0.0;
  double worst = 0.0;
  for (const float entry : list) worst = std::min(worst, static_cast<double>(entry));
  const bool listed = at >= 0.0 && at < static_cast<double>(list.size());
  const double entry = listed ? std::min(0.0F, list.Get(static_cast<int>(at))) : 0.0;
  return entry - worst;
}

// The least `measure` of an opponent and its distance from the point.
template <typename Measure>
double least_of_opponents(const player::PlannerField& field, Vec2 point, Measure measure) {
  double least = 1000.0;
  for (const player::FieldOpponent& opponent : field.opponents) {
    if (opponent.unum == 0) continue;
    const double value = measure(opponent, distance(opponent.position, point));
    least = std::min(least, value);
  }
  return least;
}

double steps_of_nearest(const player::PlannerField& field, Vec2 point) {
  return least_of_opponents(field, point, [](const auto& opponent, double distance) {
    return static_cast<double>(opponent.reach->cycles(distance));
  });
}

double distance_of_nearest(const player::PlannerField& field, Vec2 point) {
  return least_of_opponents(field, point, [](const auto&, double distance) { return distance; });
}

double with_effectors(const player::PlannerField& field, const player::Plan& plan, int node,
                      double value, const protos::PlannerEvaluationEffector& effectors) {
  const player::PlanNode& state = plan.nodes[base::index(node)];
  const player::PlanNode& first = plan.nodes[base::index(plan.first_of(node))];
  if (effectors.has_action_type_effector()) {
    value *= kind_factor(effectors.action_type_effector(), first.action.tag);
  }

  if (effectors.has_opponent_effector()) {
    const auto& opponents = effectors.opponent_effector();
    const auto at = [&](bool first_layer) { return first_layer ? first.ball : state.ball; };
    const Vec2 near = at(opponents.negetive_effect_by_distance_based_on_first_layer());
    const Vec2 reached = at(opponents.negetive_effect_by_reach_steps_based_on_first_layer());
    value +=
        listed_effect(opponents.negetive_effect_by_distance(), distance_of_nearest(field, near));
    value +=
        listed_effect(opponents.negetive_effect_by_reach_steps(), steps_of_nearest(field, reached));
  }

  if (effectors.has_teammate_effector()) {
    const auto& teammates = effectors.teammate_effector();
    const int holder = teammates.apply_based_on_first_layer() ? first.holder : state.holder;
    const auto found = teammates.coefficients().find(holder);
    if (found != teammates.coefficients().end()) value *= std::max(0.0F, found->second);
  }
  return value;
}

}  // namespace

double evaluate(const player::PlannerField& field, const player::Plan& plan, int node,
                const protos::PlannerEvaluation& evaluation) {
  // Without the message both are unset.
  const protos::PlannerFieldEvaluator& evaluators = evaluation.field_evaluators();
  const bool own_field =
      evaluators.has_helios_field_evaluator() || evaluators.has_matrix_field_evaluator();
  const double value = own_field ? field_value(field, plan.nodes[base::index(node)], evaluators)
                                 : default_value(field, plan, node);
  if (!evaluation.has_effectors()) return value;
  return with_effectors(field, plan, node, value, evaluation.effectors());
}

}  // namespace cls::proxy
