// Place, moves and saves of a goalie across the way of the ball.
#include "player/behaviors/goalie_save.h"

#include <algorithm>
#include <cmath>

#include "base/fixed_list.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/behaviors/behaviors.h"
#include "player/estimates/estimates.h"
#include "player/movement/movement.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

constexpr SaveParameters kNumbers = kBehaviors.save;

/// Unit vector from the ball to the middle of the goal, as seen from there.
Vec2 way_to_goal(const WorldModel& world, Vec2 ball) {
  const double post = world.server().goal_width / 2.0 - kNumbers.inside_post;
  const Vec2 left = soccer::with_length(Vec2{kOwnGoal.x, post} - ball, 1.0);
  const Vec2 right = soccer::with_length(Vec2{kOwnGoal.x, -post} - ball, 1.0);
  return soccer::with_length(left + right, 1.0);
}

/// Body direction while waiting: a dash forward goes to the far post, one backward to the near
/// post.
AngleDeg body_across(const WorldModel& world, Vec2 ball) {
  const AngleDeg way = AngleDeg::of(way_to_goal(world, ball));
  const bool in_middle = std::fabs(ball.y) < kNumbers.middle;
  const bool left = in_middle ? (world.self.body - way).degrees() > 0.0 : ball.y >= 0.0;
  return way + (left ? kNumbers.body_angle : -kNumbers.body_angle);
}

/// A turn and dashes, and how near they bring the goalie to the ball.
struct Run {
  bool turns = false;      ///< first
  double turn = 0.0;       ///< degrees
  double direction = 0.0;  ///< of the dashes, relative to the body then, degrees
  double missing = 1e9;    ///< meters, with the cost of the turn
  int cycle = 0;           ///< when it is nearest
};

/// Simulates runs to the ball of a shot.
class SaveSearch {
 public:
  SaveSearch(const WorldModel& world, const Shot& shot)
      : world_(world), type_(world.self_type()), cycles_(shot.cycles) {
    power_ = std::min(world.server().max_dash_power, world.self.stamina + type_.extra_stamina);
    kick_ = kickable_area(world) - kNumbers.margin;
    hands_ = is_back_pass(world) ? kick_ : catch_reach(world).sure - kNumbers.margin;

    for (int cycle = 1; cycle <= cycles_; ++cycle) {
      const Vec2 ball = ball_after(world, cycle);
      if (ball.x < kOwnGoal.x + kNumbers.before_line || !balls_.push_back(ball)) break;
    }
  }

  Run best() {
    for (double direction = -180.0; direction < 180.0; direction += kNumbers.direction_step) {
      offer({.direction = direction});
    }
    for (int cycle = 2; cycle <= cycles_; ++cycle) {
      const Vec2 way = ball_after(world_, cycle) - self_after(world_, cycle);
      offer({.turns = true, .turn = turn_to(way), .direction = 0.0});
      offer({.turns = true, .turn = turn_to(-way), .direction = 180.0});
    }
    return best_;
  }

 private:
  double turn_to(Vec2 way) const {
    const double most = max_turn(world_);
    return soccer::between((AngleDeg::of(way) - world_.self.body).degrees(), -most, most);
  }

  double reach(Vec2 ball) const {
    constexpr double kBesideArea = 0.3;  // the ball is caught inside it
    return in_own_penalty_area(ball, kBesideArea) ? hands_ : kick_;
  }

  void offer(Run run) {
    const AngleDeg body = world_.self.body + run.turn;
    const Vec2 push = dash_acceleration(world_, body, power_, run.direction);
    Vec2 position = world_.self.position;
    Vec2 velocity = world_.self.velocity;

    run.cycle = 0;
    for (const Vec2& ball : balls_) {
      const bool turning = run.turns && run.cycle == 0;
      if (!turning) velocity = speed_limited(velocity + push, type_.player_speed_max);
      position += velocity;
      velocity *= type_.player_decay;

      ++run.cycle;
      run.missing = std::max(0.0, distance(position, ball) - reach(ball));
      if (run.turns) run.missing += kNumbers.turn;
      const bool earlier = run.missing == best_.missing && run.cycle < best_.cycle;
      if (run.missing < best_.missing || earlier) best_ = run;
    }
  }

  const WorldModel& world_;
  const soccer::PlayerType& type_;
  int cycles_;
  double power_ = 0.0;
  double kick_ = 0.0;                            ///< reach, meters
  double hands_ = 0.0;                           ///< in the own area
  base::FixedList<Vec2, kMaxShotCycles> balls_;  ///< from the next cycle on, in front of the line
  Run best_;
};

}  // namespace

Vec2 place_across(const WorldModel& world, Vec2 ball) {
  constexpr double kFlat = -0.05;  // from beside the goal
  const Vec2 way = way_to_goal(world, ball);
  const double length = std::max(0.0, (kNumbers.line - ball.x) / std::min(way.x, kFlat));
  const Vec2 place = ball + way * length;
  return {std::max(place.x, kNumbers.deepest),
          std::clamp(place.y, -kNumbers.widest, kNumbers.widest)};
}

bool slide(ActionContext& c, Vec2 place, Vec2 ball) {
  const WorldModel& world = c.world;
  const soccer::PlayerType& type = world.self_type();
  const AngleDeg error = body_across(world, ball) - world.self.body;

  const double travel = 1.0 + type.player_decay;  // of two cycles, per speed
  const Vec2 missing = place - (world.self.position + world.self.velocity * travel);
  if (missing.length() < kNumbers.near_place || error.abs() > kNumbers.body_error) {
    if (error.abs() > kNumbers.exact_body) return c.slots.turn(error.degrees());
    return stop_dash(world, c.slots, true) || c.slots.turn(0.0);
  }

  constexpr double kLeastPush = 1e-4;
  const double direction = (AngleDeg::of(missing) - world.self.body).degrees();
  const double per_power = dash_acceleration(world, 1.0, direction).length();
  const double power = missing.length() / travel / std::max(kLeastPush, per_power);
  return c.slots.dash(std::min(power, world.server().max_dash_power), direction);
}

bool save_shot(ActionContext& c, const Shot& shot) {
  const WorldModel& world = c.world;
  const Vec2 next = ball_after(world, 1);
  const bool leaves = distance(next, self_after(world, 1)) > world.ball.dist_from_self ||
                      next.x < kOwnGoal.x + kNumbers.before_line;
  if (leaves && world.self.catch_probability <= 0.0 &&
      basic_tackle(world, c.slots, kNumbers.tackle_chance)) {
    return true;
  }

  const Run run = SaveSearch(world, shot).best();
  if (run.cycle == 0) return false;
  if (run.turns) return c.slots.turn(run.turn);
  return c.slots.dash(world.server().max_dash_power, run.direction);
}

}  // namespace cls::player
