// The agent's own ways to the ball.
#include <algorithm>
#include <cmath>

#include "proxy/estimates/chances.h"
#include "proxy/estimates/intercept.h"
#include "proxy/world/dash_model.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;
using soccer::AngleDeg;
using soccer::Vec2;
using Kind = InterceptPlan::Kind;

// Closer than the full kickable area, so that noise on the way does not spoil the arrival.
constexpr double kReachMargin = 0.1;

/// What dashing at full power does to the agent's strength after some cycles without a dash: the
/// same for every direction, so it is reckoned once and only as far as it is asked for.
class DashCourse {
 public:
  struct Dash {
    double power = 0.0;
    double push = 0.0;       ///< acceleration where all of the power acts
    double stamina = 0.0;    ///< left after it
    bool exhausted = false;  ///< recovery falls by it or fell before
  };

  void start(const WorldModel& world, int cycles_before) {
    server_ = &world.server();
    type_ = &world.self_type();
    const SelfState& self = world.self;
    strength_ = {self.stamina, self.effort, self.recovery, self.capacity};
    for (int i = 0; i < cycles_before; ++i) strength_.step(*server_, *type_, 0.0);
    dashes_.clear();
  }
  bool started() const { return server_ != nullptr; }

  /// The n-th dash, from 0.
  const Dash& at(int n) {
    while (dashes_.size() <= static_cast<std::size_t>(n)) dashes_.push_back(next());
    return dashes_[static_cast<std::size_t>(n)];
  }

 private:
  Dash next() {
    Dash dash;
    dash.power = std::min(server_->max_dash_power, strength_.stamina + type_->extra_stamina);
    dash.push = strength_.effort * dash.power * type_->dash_power_rate;
    strength_.step(*server_, *type_, dash.power);
    dash.stamina = strength_.stamina;
    dash.exhausted = (!dashes_.empty() && dashes_.back().exhausted) ||
                     dash.stamina <= server_->recover_dec_thr * server_->stamina_max;
    return dash;
  }

  const soccer::ServerParams* server_ = nullptr;
  const soccer::PlayerType* type_ = nullptr;
  Stamina strength_;
  FixedList<Dash, kInterceptHorizon> dashes_;
};

/// A run of the agent, step by step.
struct Runner {
  const soccer::PlayerType& type;
  Vec2 position;
  Vec2 velocity;
  int dashes = 0;

  explicit Runner(const WorldModel& world)
      : type(world.self_type()), position(world.self.position), velocity(world.self.velocity) {}

  void coast() {
    position += velocity;
    velocity *= type.player_decay;
  }

  /// One dash of full power along the unit vector `heading`, `rate` the share that acts.
  void dash(Vec2 heading, double rate, DashCourse& course) {
    velocity += heading * (rate * course.at(dashes++).push);
    if (velocity.squared_length() > type.player_speed_max * type.player_speed_max) {
      velocity = soccer::with_length(velocity, type.player_speed_max);
    }
    coast();
  }
};

/// Distance at which the agent has the ball at that point: his hands in the own penalty area.
double control_distance(const WorldModel& world, Vec2 ball) {
  const double kick = world.self_type().kickable_area(world.server().ball_size) - kReachMargin;
  const bool in_box = ball.x < -(soccer::kHalfLength - soccer::kPenaltyAreaLength) &&
                      std::fabs(ball.y) < 0.5 * soccer::kPenaltyAreaWidth;
  if (!world.goalie || !in_box || world.game.mode != soccer::PlayMode::kPlayOn) return kick;
  return std::max(kick, catch_reach(world).sure - kReachMargin);
}

// Plans kept per way of getting there; later ones only repeat the first with more waiting.
constexpr int kPlansPerDirection = 3;
constexpr int kPlansPerTurn = 8;
// A dash to the side is slow: from here on turning first is quicker.
constexpr int kSideDashHorizon = 12;
constexpr int kMostTurns = 6;

struct Search {
  const WorldModel& world;
  const BallPath& path;
  InterceptTable& table;
  /// How far full dashes forward carry from rest, by their number; and how far the present velocity
  /// carries by itself.
  std::array<double, kInterceptHorizon + 1> run{};
  std::array<double, kInterceptHorizon + 1> drift{};
  std::array<DashCourse, kMostTurns + 1> courses;  ///< by the turns before

  Search(const WorldModel& w, const BallPath& p, InterceptTable& t) : world(w), path(p), table(t) {
    const soccer::PlayerType& type = world.self_type();
    const double push = world.server().max_dash_power * type.dash_power_rate * world.self.effort;
    double speed = 0.0;
    double fading = 1.0;
    for (std::size_t i = 1; i < run.size(); ++i) {
      speed = std::min(speed + push, type.player_speed_max);
      run[i] = run[i - 1] + speed;
      drift[i] = drift[i - 1] + fading;
      speed *= type.player_decay;
      fading *= type.player_decay;
    }
  }

  double control_at(int step) const {
    return control_distance(world, path[static_cast<std::size_t>(step)]);
  }
  bool reaches(Vec2 position, int step) const {
    const double control = control_at(step);
    return soccer::squared_distance(position, path[static_cast<std::size_t>(step)]) <=
           control * control;
  }

  DashCourse& course_after(int turns) {
    DashCourse& course = courses[static_cast<std::size_t>(turns)];
    if (!course.started()) course.start(world, turns);
    return course;
  }

  void add(const Runner& runner, Kind kind, int turns, int dashes, double turn, double direction) {
    DashCourse& course = course_after(turns);
    InterceptPlan plan;
    plan.kind = kind;
    plan.turns = turns;
    plan.dashes = dashes;
    plan.turn_angle = turn;
    plan.dash_direction = direction;
    plan.self_position = runner.position;
    plan.ball_distance =
        soccer::distance(runner.position, path[static_cast<std::size_t>(turns + dashes)]);
    plan.stamina = world.self.stamina;
    if (runner.dashes > 0) {
      const DashCourse::Dash& last = course.at(runner.dashes - 1);
      plan.stamina = last.stamina;
      plan.exhausting = last.exhausted;
      plan.dash_power = course.at(0).power;
    }
    table.plans.push_back(plan);
  }

  /// Dashes in one direction off the body, without turn.
  void omni(double direction) {
    Runner runner(world);
    DashCourse& course = course_after(0);
    const Vec2 heading = polar(1.0, world.self.body + direction);
    const double rate = dash_direction_rate(world.server(), direction);
    const int horizon = direction == 0.0 ? kInterceptHorizon : kSideDashHorizon;
    int found = 0;
    for (int step = 1; step <= horizon && found < kPlansPerDirection; ++step) {
      runner.dash(heading, rate, course);
      if (!reaches(runner.position, step)) continue;
      add(runner, Kind::kOmniDash, 0, step, 0.0, direction);
      ++found;
    }
  }

  /// Turns until body (or back) points at where the ball will be at `step`, then dashes. False when
  /// the ball is not met so.
  bool turn_and_dash(int step, bool backward) {
    const Vec2 target = path[static_cast<std::size_t>(step)];
    const double control = control_at(step);
    const double rate = dash_direction_rate(world.server(), backward ? 180.0 : 0.0);
    // Aim from where coasting leads: what own speed there is keeps acting.
    const Vec2 offset = target - (world.self.position +
                                  world.self.velocity * drift[static_cast<std::size_t>(step)]);
    const double distance = offset.length();
    if (distance > run[static_cast<std::size_t>(step - 1)] * rate + control) return false;
    const AngleDeg heading = distance > 1e-3 ? AngleDeg::of(offset) : world.self.body;
    const double wanted = ((backward ? heading + 180.0 : heading) - world.self.body).degrees();
    constexpr double kLeastSlack = 5.0;
    const double slack =
        distance > control ? std::max(kLeastSlack, math::to_degrees(math::asin(control / distance)))
                           : 180.0;
    Runner runner(world);
    double missing = std::fabs(wanted);
    int turns = 0;
    while (missing > slack && turns < std::min(step, kMostTurns)) {
      missing -=
          world.server().maxmoment / (1.0 + runner.type.inertia_moment * runner.velocity.length());
      runner.coast();
      ++turns;
    }
    if (missing > slack || turns == 0) return false;  // without turn it is an omni dash
    missing = std::max(0.0, missing);
    const double turn = wanted < 0.0 ? wanted + missing : wanted - missing;
    const int dashes = step - turns;
    const Vec2 unit = polar(1.0, world.self.body + turn + (backward ? 180.0 : 0.0));
    for (int i = 0; i < dashes; ++i) {
      // A full dash that would run past the ball is left out: waiting meets it as well.
      if (soccer::dot(target - runner.position, unit) > 0.0) {
        runner.dash(unit, rate, course_after(turns));
      } else {
        runner.coast();
      }
    }
    if (!reaches(runner.position, step)) return false;
    add(runner, backward ? Kind::kTurnBackwardDash : Kind::kTurnForwardDash, turns, dashes, turn,
        backward ? 180.0 : 0.0);
    return true;
  }

  void turning(bool backward) {
    int found = 0;
    for (int step = 1; step <= kInterceptHorizon && found < kPlansPerTurn; ++step) {
      if (turn_and_dash(step, backward)) ++found;
    }
  }
};

}  // namespace

void plan_own_intercept(const WorldModel& world, const BallPath& path, InterceptTable& table) {
  table.plans.clear();
  table.self_steps = table.self_exhausting_steps = kNever;
  if (world.self.kickable) {
    table.self_steps = 0;
    return;
  }
  Search search(world, path, table);
  constexpr double kDirections[] = {0.0, 45.0, -45.0, 90.0, -90.0, 135.0, -135.0, 180.0};
  for (const double direction : kDirections) search.omni(direction);
  search.turning(false);
  search.turning(true);
  std::sort(table.plans.begin(), table.plans.end(),
            [](const InterceptPlan& a, const InterceptPlan& b) {
              if (a.steps() != b.steps()) return a.steps() < b.steps();
              if (a.turns != b.turns) return a.turns < b.turns;
              return a.stamina > b.stamina;
            });
  for (const InterceptPlan& plan : table.plans) {
    int& steps = plan.exhausting ? table.self_exhausting_steps : table.self_steps;
    steps = std::min(steps, plan.steps());
  }
}

}  // namespace cls::proxy
