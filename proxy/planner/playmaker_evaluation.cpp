// Computes the field value, then applies the effectors in the order of the interface.
#include "proxy/planner/playmaker_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "player/planner/evaluation.h"
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
  const auto factor = [](float value) { return std::max(0.0, static_cast<double>(value)); };
  switch (first) {
    case player::PlanTag::kStrictDirect:
      return factor(factors.direct_pass());
    case player::PlanTag::kStrictLead:
      return factor(factors.lead_pass());
    case player::PlanTag::kStrictThrough:
      return factor(factors.through_pass());
    case player::PlanTag::kCross:
      return factor(factors.cross());
    case player::PlanTag::kShortDribble:
      return factor(factors.short_dribble());
    case player::PlanTag::kSelfPass:
      return factor(factors.long_dribble());
    case player::PlanTag::kHold:
      return factor(factors.hold());
    default:
      return 1.0;
  }
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

double steps_of_nearest(const player::PlannerField& field, Vec2 point) {
  double steps = 1000.0;
  for (const player::FieldOpponent& opponent : field.opponents) {
    if (opponent.unum == 0) continue;
    const double dist = distance(opponent.position, point);
    steps = std::min(steps, static_cast<double>(opponent.reach->cycles(dist)));
  }
  return steps;
}

double distance_of_nearest(const player::PlannerField& field, Vec2 point) {
  double least = 1000.0;
  for (const player::FieldOpponent& opponent : field.opponents) {
    if (opponent.unum != 0) least = std::min(least, distance(opponent.position, point));
  }
  return least;
}

double with_effectors(const player::PlannerField& field, const player::Plan& plan, int node,
                      double value, const protos::PlannerEvaluationEffector& effectors) {
  const player::PlanNode& state = plan.nodes[static_cast<std::size_t>(node)];
  const player::PlanNode& first = plan.nodes[static_cast<std::size_t>(plan.first_of(node))];
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
  const player::PlanNode& state = plan.nodes[static_cast<std::size_t>(node)];
  double value = 0.0;
  const bool own_field = evaluation.has_field_evaluators() &&
                         (evaluation.field_evaluators().has_helios_field_evaluator() ||
                          evaluation.field_evaluators().has_matrix_field_evaluator());
  if (own_field) {
    value = field_value(field, state, evaluation.field_evaluators());
  } else {
    value = default_value(field, plan, node);
  }
  if (!evaluation.has_effectors()) return value;
  return with_effectors(field, plan, node, value, evaluation.effectors());
}

}  // namespace cls::proxy
