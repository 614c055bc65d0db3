// Intercept plans of the agent, simulated cycle by cycle with stamina.
#include <algorithm>
#include <cmath>

#include "player/estimates/ball_control.h"
#include "player/estimates/intercept.h"
#include "player/world/running.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

namespace math = soccer::math;
using soccer::AngleDeg;
using soccer::Vec2;
using Kind = InterceptPlan::Kind;

// Safety margin against motion noise.
constexpr double kReachMargin = 0.1;

/// Stamina after each full-power dash, following some cycles without a dash. Independent of the
/// direction; computed lazily.
class DashCourse {
 public:
  struct Dash {
    double power = 0.0;
    double push = 0.0;       ///< acceleration at dash rate 1
    double stamina = 0.0;    ///< left after it
    bool exhausted = false;  ///< this dash or an earlier one decreases recovery
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
  base::FixedList<Dash, kInterceptHorizon> dashes_;
};

/// Simulates a run of the agent cycle by cycle.
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

  /// One full-power dash along the unit vector `heading` with dash rate `rate`.
  void dash(Vec2 heading, double rate, DashCourse& course) {
    velocity += heading * (rate * course.at(dashes++).push);
    if (velocity.squared_length() > type.player_speed_max * type.player_speed_max) {
      velocity = soccer::with_length(velocity, type.player_speed_max);
    }
    coast();
  }
};

/// Distance at which the agent controls the ball: kickable area, or catch reach of a goalie in its
/// penalty area.
class Control {
 public:
  explicit Control(const WorldModel& world)
      : kick_(world.self_type().kickable_area(world.server().ball_size) - kReachMargin),
        catches_(world.goalie && world.game.mode == soccer::PlayMode::kPlayOn) {
    if (catches_) catch_ = std::max(kick_, catch_reach(world).sure - kReachMargin);
  }

  double at(Vec2 ball) const {
    if (!catches_) return kick_;
    const bool in_box = ball.x < -(soccer::kHalfLength - soccer::kPenaltyAreaLength) &&
                        std::fabs(ball.y) < 0.5 * soccer::kPenaltyAreaWidth;
    return in_box ? catch_ : kick_;
  }

 private:
  double kick_;
  double catch_ = 0.0;
  bool catches_;
};

// Maximum plans per direction or turn; later plans only add waiting cycles.
constexpr int kPlansPerDirection = 3;
constexpr int kPlansPerTurn = 8;
// Side dashes are slow: beyond this horizon turning first is faster.
constexpr int kSideDashHorizon = 12;
constexpr int kMaxTurns = 6;

struct Search {
  const WorldModel& world;
  const BallPath& path;
  InterceptTable& table;
  Control control;
  double forward_rate = 0.0;  ///< dash rates
  double backward_rate = 0.0;
  /// Distance by number of full forward dashes from rest; distance per unit of current velocity by
  /// cycle.
  std::array<double, kInterceptHorizon + 1> run{};
  std::array<double, kInterceptHorizon + 1> drift{};
  std::array<DashCourse, kMaxTurns + 1> courses;  ///< by number of preceding turns

  Search(const WorldModel& w, const BallPath& p, InterceptTable& t)
      : world(w), path(p), table(t), control(w) {
    const soccer::PlayerType& type = world.self_type();
    forward_rate = dash_rate(world.server(), 0.0);
    backward_rate = dash_rate(world.server(), 180.0);

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

  double control_at(int step) const { return control.at(path[static_cast<std::size_t>(step)]); }
  bool reaches(Vec2 position, int step) const {
    const double reach = control_at(step);
    return soccer::squared_distance(position, path[static_cast<std::size_t>(step)]) <=
           reach * reach;
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

  /// Dashes in one direction relative to the body, without turning.
  void omni(double direction) {
    Runner runner(world);
    DashCourse& course = course_after(0);
    const Vec2 heading = polar(1.0, world.self.body + direction);
    const double rate = dash_rate(world.server(), direction);
    const int horizon = direction == 0.0 ? kInterceptHorizon : kSideDashHorizon;
    int found = 0;

    for (int step = 1; step <= horizon && found < kPlansPerDirection; ++step) {
      runner.dash(heading, rate, course);
      if (!reaches(runner.position, step)) continue;
      add(runner, Kind::kOmniDash, 0, step, 0.0, direction);
      ++found;
    }
  }

  /// Turns until the body (or back) points at the ball position at `step`, then dashes. False when
  /// this does not reach the ball.
  bool turn_and_dash(int step, bool backward) {
    const Vec2 target = path[static_cast<std::size_t>(step)];
    const double reach = control_at(step);
    const double rate = backward ? backward_rate : forward_rate;

    // Aim from the coasting position: the current velocity persists.
    const Vec2 offset = target - (world.self.position +
                                  world.self.velocity * drift[static_cast<std::size_t>(step)]);
    const double distance = offset.length();
    if (distance > run[static_cast<std::size_t>(step - 1)] * rate + reach) return false;

    const AngleDeg heading = distance > 1e-3 ? AngleDeg::of(offset) : world.self.body;
    const double desired_turn =
        ((backward ? heading + 180.0 : heading) - world.self.body).degrees();
    constexpr double kMinSlack = 5.0;
    const double slack = distance > reach
                             ? std::max(kMinSlack, math::to_degrees(math::asin(reach / distance)))
                             : 180.0;

    Runner runner(world);
    double missing = std::fabs(desired_turn);
    int turns = 0;
    while (missing > slack && turns < std::min(step, kMaxTurns)) {
      missing -=
          world.server().maxmoment / (1.0 + runner.type.inertia_moment * runner.velocity.length());
      runner.coast();
      ++turns;
    }

    if (missing > slack || turns == 0) return false;  // without a turn it is an omni dash
    missing = std::max(0.0, missing);
    const double turn = desired_turn < 0.0 ? desired_turn + missing : desired_turn - missing;
    const int dashes = step - turns;

    const Vec2 unit = polar(1.0, world.self.body + turn + (backward ? 180.0 : 0.0));
    for (int i = 0; i < dashes; ++i) {
      // Skip a full dash that would overrun the ball; waiting reaches it too.
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

void plan_self_intercept(const WorldModel& world, const BallPath& path, InterceptTable& table) {
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

}  // namespace cls::player
