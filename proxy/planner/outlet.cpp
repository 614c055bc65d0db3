// Every direction and a few speeds, followed until somebody has the ball.
#include "proxy/planner/outlet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "proxy/ball_skills/kick.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

using soccer::Vec2;

constexpr int kDirections = 60;
constexpr std::array<double, 4> kSpeedShares{1.0, 0.8, 0.65, 0.5};  ///< of the fastest kick

bool on_pitch(Vec2 point) {
  return std::fabs(point.x) < soccer::kHalfLength && std::fabs(point.y) < soccer::kHalfWidth;
}

bool is_goal_kick(soccer::PlayMode mode) {
  return mode == soccer::PlayMode::kGoalKickLeft || mode == soccer::PlayMode::kGoalKickRight;
}

bool in_own_box(Vec2 point) {
  return point.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength &&
         std::fabs(point.y) < soccer::kPenaltyAreaWidth / 2.0;
}

/// The player is where the ball will be in that cycle, in time.
bool gets(const FieldPlayer& player, Vec2 ball, int cycle) {
  const double far = player.control + player.reach->run(cycle) + player.velocity.length() * 2.0;
  if (squared_distance(player.position, ball) > far * far) return false;
  return cycles_to_get(player, ball) <= cycle;
}

class OutletSearch {
 public:
  explicit OutletSearch(const PlannerField& field)
      : field_(field), goal_kick_(is_goal_kick(field.world.game.mode)) {
    constexpr int kStale = 15;
    for (const FieldPlayer& mate : field.mates) {
      const bool offside = field.open_play && mate.position.x > field.world.lines.offside;
      if (!mate.goalie && !mate.ghost && mate.age <= kStale && !offside) mates_.push_back(&mate);
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
      if (!on_pitch(outlet.target)) {
        outlet.value = value_of_loss(outlet.target) + kKickIn;
        return outlet;
      }
      if (opponent_gets(outlet.target, cycle)) break;
      if (mate_gets(outlet.target, cycle)) {
        const int ahead = opponents_cycles_to(field_, outlet.target, true) - cycle;
        outlet.ours = true;
        outlet.value = value_of_gain(outlet.target, ahead);
        return outlet;
      }
    }
    outlet.value = value_of_loss(outlet.target);
    return outlet;
  }

  bool opponent_gets(Vec2 ball, int cycle) const {
    constexpr int kMostCredit = 5;
    return std::any_of(field_.opponents.begin(), field_.opponents.end(),
                       [&](const FieldOpponent& opponent) {
                         const int credit = std::min(opponent.age, kMostCredit);
                         return gets(opponent, ball, cycle + 1 + credit);
                       });
  }
  bool mate_gets(Vec2 ball, int cycle) const {
    // A goal kick is in play once it has left the area.
    if (goal_kick_ && in_own_box(ball)) return false;
    constexpr int kSurprise = 4;  // cycles until everybody has seen where it goes and runs
    return std::any_of(mates_.begin(), mates_.end(), [&](const FieldPlayer* mate) {
      return gets(*mate, ball, cycle - kSurprise);
    });
  }

  // A kick-in leaves us time to be in our places.
  static constexpr double kKickIn = 8.0;
  static double value_of_loss(Vec2 ball) {
    if (ball.x <= -soccer::kHalfLength) return -100.0;  // a corner, or worse
    return 0.5 * (ball.x + soccer::kHalfLength) + 0.4 * std::fabs(ball.y);
  }
  /// `ahead`: cycles that the nearest opponent comes later than the ball.
  static double value_of_gain(Vec2 ball, int ahead) {
    constexpr double kSafe = 7.0;
    constexpr double kTouchLine = soccer::kHalfWidth - 3.0;  // missed there, it is theirs
    const double share = std::clamp(ahead / kSafe, 0.0, std::fabs(ball.y) < kTouchLine ? 1.0 : 0.7);
    // Taken off its receiver it is a loss there.
    return share * (30.0 + ball.x + soccer::kHalfLength) + (1.0 - share) * value_of_loss(ball);
  }

  const PlannerField& field_;
  bool goal_kick_;
  FixedList<const FieldPlayer*, 22> mates_;
  std::optional<Outlet> best_;
};

}  // namespace

std::optional<Outlet> best_outlet(const PlannerField& field) { return OutletSearch(field).run(); }

}  // namespace cls::proxy
