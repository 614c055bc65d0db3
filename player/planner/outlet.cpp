// Simulates all directions and several speeds until a player gets the ball.
#include "player/planner/planner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "player/ball_skills/ball_skills.h"
#include "player/world/candidates.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

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

std::optional<Outlet> best_outlet(const PlannerField& field) { return OutletSearch(field).run(); }

}  // namespace cls::player
