// Values of planner states, best-first search up to a maximum number of nodes, and outlets: all
// directions and several speeds until a player gets the ball.
#include "player/planner/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "player/ball_skills/ball_skills.h"
#include "player/planner/generators.h"
#include "player/world/candidates.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

// Values of a goal, a shooting chance, one of the agent itself, and an impossible state.
constexpr double kGoal = 1e7;
constexpr double kShot = 1e6;
constexpr double kOwnShot = 5e5;
constexpr double kImpossible = 1e300;

class Search {
 public:
  Search(const PlannerField& field, const PlannerOptions& options, const NodeValue& value)
      : field_(field), options_(options), value_(value) {
    plan_.nodes.reserve(base::index(options.max_nodes) + 1);
  }

  Plan run() {
    add_root();
    while (!open_.empty() && count() < options_.max_nodes) {
      const int node = -open_.top().second;
      open_.pop();
      expand(node);
    }
    return std::move(plan_);
  }

 private:
  int count() const { return static_cast<int>(plan_.nodes.size()); }

  void add_root() {
    const int self = field_.self.unum;
    add({.action = {.sender = self, .target = self, .target_point = field_.ball, .final = true},
         .holder = self,
         .ball = field_.ball,
         .our_defense_line = field_.world.lines.our_defense});
    open_.push({plan_.nodes[0].value, 0});
  }

  void generate(int node) {
    actions_.clear();

    if (node == 0) {
      if (options_.passes) add_passes(field_, actions_);
      if (options_.cross) add_crosses(field_, actions_);
      if (options_.short_dribble) add_short_dribbles(field_, actions_);
      if (options_.long_dribble) add_self_passes(field_, actions_);
      return;
    }

    const CoarseState state{field_, plan_, node};
    if (options_.simple_pass) add_simple_passes(state, actions_);
    if (options_.simple_dribble) add_simple_dribbles(state, actions_);
    if (options_.simple_shoot) add_simple_shot(state, actions_);
  }

  PlanNode child(int parent, const PlanAction& action) const {
    const PlanNode& from = plan_.at(parent);
    return {.action = action,
            .parent = parent,
            .depth = from.depth + 1,
            .holder = action.target,
            .ball = action.target_point,
            .time = from.time + action.duration,
            .our_defense_line = std::min(from.our_defense_line, action.target_point.x)};
  }

  /// Adds and evaluates a node.
  void add(const PlanNode& node) {
    plan_.nodes.push_back(node);
    plan_.nodes.back().value = value_(field_, plan_, count() - 1);
  }

  /// Keeps only the best first actions of each kind and receiver, so that the tree has room for
  /// later actions.
  void prune_first_actions() {
    constexpr int kMaxPerKind = 10;
    std::vector<std::pair<double, std::size_t>> order;

    for (std::size_t i = 0; i < actions_.size(); ++i) {
      add(child(0, actions_[i]));
      order.emplace_back(-plan_.nodes.back().value, i);
      plan_.nodes.pop_back();
    }
    std::ranges::sort(order);

    std::map<std::pair<PlanTag, int>, int> taken;
    std::vector<PlanAction> best;
    const std::size_t max_count = base::index(std::max(10, options_.max_nodes / 3));
    for (const auto& [value, i] : order) {
      const PlanAction& action = actions_[i];
      if (best.size() >= max_count) break;
      if (taken[{action.tag, action.target}]++ < kMaxPerKind) best.push_back(action);
    }

    actions_ = std::move(best);
  }

  void expand(int parent) {
    generate(parent);
    if (parent == 0) prune_first_actions();

    for (const PlanAction& action : actions_) {
      if (count() >= options_.max_nodes) return;
      const int index = count();
      add(child(parent, action));
      const PlanNode& node = plan_.nodes.back();
      if (node.value > plan_.at(plan_.best).value) plan_.best = index;
      // Ties: the earlier node first.
      if (!action.final && node.depth < options_.max_depth) open_.push({node.value, -index});
    }
  }

  const PlannerField& field_;
  const PlannerOptions& options_;
  const NodeValue& value_;
  Plan plan_;
  std::vector<PlanAction> actions_;
  std::priority_queue<std::pair<double, int>> open_;
};

constexpr int kDirections = 60;
constexpr std::array<double, 4> kSpeedShares{1.0, 0.8, 0.65,
                                             0.5};  ///< fractions of the maximum speed

/// True if the player reaches the ball position by that cycle.
bool gets(const FieldPlayer& player, Vec2 ball, int cycle) {
  const double far = player.control + player.reach->run(cycle) + player.velocity.length() * 2.0;
  if (squared_distance(player.position, ball) > far * far) return false;
  return cycles_to_get(player, ball) <= cycle;
}

class OutletSearch {
 public:
  explicit OutletSearch(const PlannerField& field)
      : field_(field), goal_kick_(without_side(field.world.game.mode) == PlayMode::kGoalKickLeft) {
    constexpr int kMaxAge = 15;
    for (const FieldPlayer& teammate : field.teammates) {
      const bool offside = field.open_play && teammate.position.x > field.world.lines.offside;
      if (!teammate.goalie && !teammate.ghost && teammate.age <= kMaxAge && !offside)
        teammates_.push_back(&teammate);
    }
  }

  std::optional<Outlet> run() {
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 direction = soccer::polar_degrees(1.0, 360.0 * i / kDirections);
      const double limit = field_.kick_limit;
      const double fastest = max_speed_along(field_.ball_velocity, direction, limit,
                                             field_.world.server().ball_speed_max);
      if (fastest <= 0.0) continue;
      for (const double share : kSpeedShares) consider(direction, 0.98 * fastest * share);
    }

    return best_;
  }

 private:
  void consider(Vec2 direction, double speed) {
    if ((direction * speed - field_.ball_velocity).length() > field_.kick_limit) return;
    const Outlet outlet = outcome(direction, speed);
    if (!best_ || outlet.value > best_->value) best_ = outlet;
  }

  Outlet outcome(Vec2 direction, double speed) const {
    Outlet outlet;
    outlet.speed = speed;

    for (int cycle = 1; cycle <= kPlannerHorizon; ++cycle) {
      outlet.target = field_.ball + direction * (speed * field_.roll(cycle));
      if (!inside_pitch(outlet.target)) {
        // Bonus: a kick-in gives us time to take positions.
        outlet.value = value_of_loss(outlet.target) + field_.parameters.outlet_kick_in;
        return outlet;
      }

      if (opponent_gets(outlet.target, cycle)) break;
      if (teammate_gets(outlet.target, cycle)) {
        const int ahead = opponents_cycles_to(field_, outlet.target, true) - cycle;
        outlet.teammate_first = true;
        outlet.value = value_of_gain(outlet.target, ahead);
        return outlet;
      }
    }

    outlet.value = value_of_loss(outlet.target);
    return outlet;
  }

  bool opponent_gets(Vec2 ball, int cycle) const {
    constexpr int kMaxCredit = 5;
    return std::ranges::any_of(field_.opponents, [&](const FieldOpponent& opponent) {
      return gets(opponent, ball, cycle + 1 + std::min(opponent.age, kMaxCredit));
    });
  }
  bool teammate_gets(Vec2 ball, int cycle) const {
    // A goal kick is in play after leaving the penalty area.
    if (goal_kick_ && in_own_box(ball)) return false;
    return std::ranges::any_of(teammates_, [&](const FieldPlayer* teammate) {
      return gets(*teammate, ball, cycle - field_.parameters.outlet_reaction);
    });
  }

  double value_of_loss(Vec2 ball) const {
    if (ball.x <= -soccer::kHalfLength) return -100.0;  // corner kick or own goal
    return field_.parameters.outlet_x_weight * (ball.x + soccer::kHalfLength) +
           field_.parameters.outlet_y_weight * std::fabs(ball.y);
  }
  /// `ahead`: cycles by which the nearest opponent is later than the ball.
  double value_of_gain(Vec2 ball, int ahead) const {
    constexpr double kTouchLine = soccer::kHalfWidth - 3.0;  // beyond it a missed ball goes out
    const double max_share = std::fabs(ball.y) < kTouchLine ? 1.0 : 0.7;
    const double share = std::clamp(ahead / field_.parameters.outlet_safe_lead, 0.0, max_share);
    // With the remaining probability the receiver loses the ball there.
    return share * (field_.parameters.outlet_gain + ball.x + soccer::kHalfLength) +
           (1.0 - share) * value_of_loss(ball);
  }

  const PlannerField& field_;
  bool goal_kick_;
  base::FixedList<const FieldPlayer*, 22> teammates_;
  std::optional<Outlet> best_;
};

}  // namespace

double ball_value(const PlannerField& field, const PlanNode& state, const FieldWeights& weights) {
  constexpr double kGoalLine = soccer::kHalfLength - 0.1;
  const double half_mouth = field.world.server().goal_width / 2.0 + 2.0;
  const Vec2 ball = state.ball;
  const bool between_posts = std::fabs(ball.y) < half_mouth;

  if (state.holder == 0) return -kImpossible;
  if (ball.x > kGoalLine && between_posts) return kGoal;
  if (ball.x < -kGoalLine && between_posts) return -kGoal;
  if (outside_pitch(ball)) return -kImpossible;

  const double to_goal = distance(ball, kOpponentGoal);
  double value = weights.x * (ball.x + soccer::kHalfLength) +
                 weights.goal_distance * std::max(0.0, weights.goal_radius - to_goal);

  constexpr int kShooterAge = 8;
  if (can_shoot_from(field, ball, state.holder, kShooterAge)) {
    value += kShot;
    if (state.holder == field.self.unum) value += kOwnShot;
  }

  return value;
}

double default_value(const PlannerField& field, const Plan& plan, int node) {
  const PlanNode& state = plan.at(node);
  const PlannerParameters& parameters = field.parameters;
  double value = ball_value(field, state,
                            {parameters.x_weight, parameters.goal_weight, parameters.goal_radius});

  if (value == -kImpossible) return value;
  value -=
      parameters.cycle_cost * state.time + parameters.action_cost * std::max(0, state.depth - 1);
  if (std::fabs(value) >= kShot / 2.0) return value;

  const Vec2 ball = state.ball;
  if (std::fabs(ball.y) > parameters.deep_y) {
    value -= parameters.deep_cost * std::max(0.0, ball.x - parameters.deep_x);
  }

  const double close = parameters.pressure_distance;
  const double room = nearest_opponent(field, ball);
  if (state.depth > 0 && room < close) value -= parameters.pressure_cost * (close - room);

  if (state.depth == 0) {
    const int held_long = field.held - parameters.hold_cycles;
    value -= std::clamp(parameters.hold_cost * held_long, 0.0, parameters.hold_limit);
    value -= parameters.hold_pressure_cost * std::max(0.0, close - room);
  }

  return value;
}

Plan make_plan(const PlannerField& field, const PlannerOptions& options, const NodeValue& value) {
  return Search(field, options, value).run();
}

std::optional<Outlet> best_outlet(const PlannerField& field) { return OutletSearch(field).run(); }

}  // namespace cls::player
