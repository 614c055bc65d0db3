// Simulates shots against candidate goalie positions.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/fixed_list.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/behaviors/goalie_save.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/planner_parameters.h"
#include "player/world/running.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

constexpr GoalieParameters kNumbers = kBehaviors.goalie;
constexpr double kGoalX = kOwnGoal.x;
constexpr int kTargets = 9;     ///< target points between the posts
constexpr int kMaxCycles = 16;  ///< maximum cycles of a shot
constexpr double kShotRange = 24.0;

/// A possible shooter.
struct Shooter {
  Vec2 from;
  int notice = 0;  ///< cycles until the shooter has the ball
  double weight = 1.0;
};

/// Ball positions of one shot by cycle until the goal line.
struct Flight {
  base::FixedList<Vec2, kMaxCycles> ball;
  int notice = 0;
  double weight = 1.0;
};

class OpenGoal {
 public:
  OpenGoal(const WorldModel& world, Vec2 ball)
      : reach_(world.server(), world.self_type()),
        arms_(kNumbers.arms * world.server().catchable_area_l),
        half_goal_(world.server().goal_width / 2.0 - 0.4) {
    add({ball, 0, 1.0}, world.server().ball_decay);
    // Opponents near our goal may shoot after a pass.
    constexpr double kNear = 22.0;
    constexpr int kMaxAge = 8;
    constexpr double kPassSpeed = 2.0;
    for (const PlayerState& opponent : world.opponents) {
      if (opponent.ghost() || opponent.pos_count > kMaxAge || opponent.goalie) continue;
      const Vec2 from = opponent.position;
      const double pass = distance(from, ball);
      const bool possible = distance(from, kOwnGoal) <= kNear && pass >= 3.0 && pass <= 25.0;
      if (!possible) continue;  // nor is a place that is not a number

      if (flights_.size() + kTargets > flights_.capacity()) break;
      add({from, 2 + static_cast<int>(pass / kPassSpeed), kNumbers.passed_weight},
          world.server().ball_decay);
    }
  }

  /// Open part of the goal for a goalie at that position; 0 if every shot is covered.
  double open(Vec2 position) const {
    double sum = 0.0;
    for (const Flight& flight : flights_) {
      double missing = 100.0;
      int cycle = flight.notice;
      for (const Vec2& ball : flight.ball) {
        // Reach reduced for turning, which takes a cycle, and side dashes.
        const double run = kNumbers.run * reach_.run(std::max(0, cycle++ - 1));
        missing = std::min(missing, distance(position, ball) - arms_ - run);
      }
      if (missing > 0.0) {
        sum += flight.weight * (kNumbers.open_shot + std::min(missing, kNumbers.max_missing));
      }
    }

    return sum;
  }

 private:
  void add(const Shooter& shooter, double decay) {
    for (int i = 0; i < kTargets; ++i) {
      const Vec2 target{kGoalX, half_goal_ * (2.0 * i / (kTargets - 1) - 1.0)};
      const Vec2 way = target - shooter.from;
      Vec2 velocity = soccer::with_length(way, kNumbers.shot_speed);
      Vec2 ball = shooter.from;

      Flight flight{{}, shooter.notice, shooter.weight};
      for (int cycle = 0; cycle < kMaxCycles; ++cycle) {
        ball += velocity;
        velocity *= decay;
        if (ball.x <= kGoalX) break;
        flight.ball.push_back(ball);
      }
      flights_.push_back(flight);
    }
  }

  ReachTable reach_;
  double arms_;
  double half_goal_;
  base::FixedList<Flight, kTargets * 4> flights_;
};

/// Point on the line from the ball to a point behind the goal, which roughly bisects the angle.
Vec2 point_on_bisector(const WorldModel& world, Vec2 ball, double x) {
  constexpr double kBehind = 7.0;
  const double post = world.server().goal_width / 2.0 - 0.5;
  const Vec2 behind{kGoalX - kBehind, 0.0};
  const double share = (x - behind.x) / std::max(0.5, ball.x - behind.x);
  return {x, soccer::between(ball.y * std::clamp(share, 0.0, 1.0), -post, post)};
}

}  // namespace

Vec2 goalie_position(const WorldModel& world, Vec2 ball) {
  const double far = distance(ball, kOwnGoal);
  // The farther the ball, the farther out, but within reach of the line.
  if (far > kShotRange) return point_on_bisector(world, ball, far > 40.0 ? -48.0 : -50.0);
  if (world.planner->goalie_across != 0) return place_across(world, ball);

  static constexpr double kOnLine = -52.2;  // at the post against shots from the goal line
  static constexpr std::array<double, 5> kLines{-50.0, -51.3, -48.8, -47.5, kOnLine};
  constexpr double kStep = 0.75;

  const OpenGoal goal(world, ball);
  Lowest<Vec2> best{1e9, point_on_bisector(world, ball, kLines[0])};

  for (const double x : kLines) {
    if (x > ball.x - 1.0 && x > kOnLine) continue;  // behind the ball
    for (double y = -6.75; y <= 6.75; y += kStep) {
      const Vec2 position{x, y};
      // Ties: prefer the nearest position.
      best.offer(goal.open(position) + kNumbers.way * distance(position, world.self.position) +
                     kNumbers.line * std::fabs(x - kLines[0]),
                 position);
    }
  }

  return best.value;
}

}  // namespace cls::player
