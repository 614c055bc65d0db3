// Intercept plans of the agent, simulated cycle by cycle with stamina.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "player/estimates/estimates.h"
#include "player/world/leg_dash.h"
#include "player/world/running.h"
#include "soccer/directions.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

using Kind = InterceptPlan::Kind;

// Safety margin against motion noise.
constexpr double kReachMargin = 0.1;

/// Stamina after each full-power dash, following some cycles without a dash. Independent of the
/// direction; computed lazily.
class DashCourse {
 public:
  struct Dash {
    double power = 0.0;
    double push = 0.0;  ///< acceleration at dash rate 1
    // After this and the earlier dashes from rest, at dash rate 1 and without a speed limit.
    double run = 0.0;
    double speed = 0.0;
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
  /// Number of dashes computed so far.
  int known() const { return static_cast<int>(dashes_.size()); }

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
    const Dash before = dashes_.empty() ? Dash{} : dashes_.back();
    dash.run = before.run + before.speed + dash.push;
    dash.speed = (before.speed + dash.push) * type_->player_decay;
    strength_.step(*server_, *type_, dash.power);
    dash.stamina = strength_.stamina;
    dash.exhausted =
        before.exhausted || dash.stamina <= server_->recover_dec_thr * server_->stamina_max;
    return dash;
  }

  const soccer::ServerParams* server_ = nullptr;
  const soccer::PlayerType* type_ = nullptr;
  Stamina strength_;
  base::FixedList<Dash, kInterceptHorizon> dashes_;
};

/// Simulates a run of the agent cycle by cycle.
struct Runner {
  const soccer::PlayerType* type;
  Vec2 position;
  Vec2 velocity;
  int dashes = 0;

  explicit Runner(const WorldModel& world)
      : type(&world.self_type()), position(world.self.position), velocity(world.self.velocity) {}
  Runner(const soccer::PlayerType& t, Vec2 p, Vec2 v) : type(&t), position(p), velocity(v) {}

  void coast() {
    position += velocity;
    velocity *= type->player_decay;
  }

  void push(Vec2 acceleration) {
    velocity += acceleration;
    const double limit = type->player_speed_max;
    if (velocity.squared_length() > limit * limit) velocity = soccer::with_length(velocity, limit);
    coast();
  }

  /// One full-power dash along the unit vector `heading` with dash rate `rate`.
  void dash(Vec2 heading, double rate, DashCourse& course) {
    push(heading * (rate * course.at(dashes++).push));
  }

  /// `cycles` of dashes, without those that would overrun `target`.
  void dash_up_to(Vec2 target, Vec2 heading, double rate, int cycles, DashCourse& course) {
    for (int i = 0; i < cycles; ++i) {
      if (soccer::dot(target - position, heading) > 0.0) {
        dash(heading, rate, course);
      } else {
        coast();
      }
    }
  }
};

/// Distance at which the agent controls the ball: kickable area, or catch reach of a goalie in its
/// penalty area.
class Control {
 public:
  explicit Control(const WorldModel& world)
      : kick_(world.self_type().kickable_area(world.server().ball_size) - kReachMargin),
        catches_(world.goalie && world.game.mode == PlayMode::kPlayOn) {
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

/// The agent after some cycles without a dash.
struct Coasting {
  Vec2 position;
  Vec2 velocity;
  double max_turn = 0.0;  ///< degrees, of a turn in the next cycle
};

struct Search {
  const WorldModel& world;
  const BallPath& path;
  const int most_steps;
  InterceptTable& table;
  Control control;
  double forward_rate = 0.0;  ///< dash rates
  double backward_rate = 0.0;
  double unlimited_rate = 0.0;  ///< up to this dash rate a run never gets to the speed limit
  /// Distance by number of full forward dashes from rest; velocity and distance per unit of current
  /// velocity by cycle.
  std::array<double, kInterceptHorizon + 1> run{};
  std::array<double, kInterceptHorizon + 1> fading{};
  std::array<double, kInterceptHorizon + 1> drift{};
  /// The ball, as seen from the coasting agent, by cycle.
  std::array<Vec2, kInterceptHorizon + 1> offsets{};
  std::array<Coasting, kMaxTurns + 1> coasting;   ///< by number of turns
  std::array<DashCourse, kMaxTurns + 1> courses;  ///< by number of preceding turns

  Search(const WorldModel& w, const BallPath& p, int most, InterceptTable& t)
      : world(w), path(p), most_steps(most), table(t), control(w) {
    const soccer::PlayerType& type = world.self_type();
    forward_rate = dash_rate(world.server(), 0.0);
    backward_rate = dash_rate(world.server(), 180.0);

    const double push = world.server().max_dash_power * type.dash_power_rate * world.self.effort;
    // A speed of at most decay * limit plus a push of at most (1 - decay) * limit is within it.
    const double most_push = world.server().max_dash_power * type.dash_power_rate * type.effort_max;
    if (world.self.velocity.length() <= type.player_decay * type.player_speed_max) {
      unlimited_rate = (1.0 - type.player_decay) * type.player_speed_max / most_push;
    }

    double speed = 0.0;
    fading[0] = 1.0;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(most_steps); ++i) {
      speed = std::min(speed + push, type.player_speed_max);
      run[i] = run[i - 1] + speed;
      fading[i] = fading[i - 1] * type.player_decay;
      drift[i] = drift[i - 1] + fading[i - 1];
      speed *= type.player_decay;
      offsets[i] = path[i] - (world.self.position + world.self.velocity * drift[i]);
    }
    coast();
  }

  void coast() {
    const soccer::PlayerType& type = world.self_type();
    Runner runner(world);
    for (Coasting& state : coasting) {
      state = {runner.position, runner.velocity,
               world.server().maxmoment / (1.0 + type.inertia_moment * runner.velocity.length())};
      runner.coast();
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

  /// The runner after full dashes along `heading` within the speed limit, in closed form.
  void run_straight(Runner& runner, Vec2 heading, double rate, int dashes,
                    DashCourse& course) const {
    if (dashes == 0) return;
    const DashCourse::Dash& last = course.at(dashes - 1);
    const auto n = static_cast<std::size_t>(dashes);
    runner.position += runner.velocity * drift[n] + heading * (rate * last.run);
    runner.velocity = runner.velocity * fading[n] + heading * (rate * last.speed);
    runner.dashes += dashes;
  }

  /// A number of dashes, 1 to `cycles`, such that all smaller ones bring a run less than `missing`
  /// ahead. `along` is its velocity; searches the dashes that are known.
  int least_dashes(double missing, double along, double rate, int cycles,
                   DashCourse& course) const {
    // No rounding makes the distance shrink from one number of dashes to the next if the agent does
    // not run back first.
    const double helping = std::max(0.0, along);
    int least = 1;
    int most = std::clamp(course.known(), 1, cycles);
    while (least < most) {
      const int middle = (least + most) / 2;
      const double ahead =
          helping * drift[static_cast<std::size_t>(middle)] + rate * course.at(middle - 1).run;
      if (ahead < missing) {
        least = middle + 1;
      } else {
        most = middle;
      }
    }
    return least;
  }

  /// `cycles` of full dashes along `heading`, without those that would overrun `target`: waiting
  /// reaches it too.
  void dash_toward(Vec2 target, Runner& runner, Vec2 heading, double rate, int cycles,
                   DashCourse& course) const {
    const double missing = soccer::dot(target - runner.position, heading);
    if (rate > unlimited_rate || missing <= 0.0) {
      return runner.dash_up_to(target, heading, rate, cycles, course);
    }

    const double along = soccer::dot(runner.velocity, heading);
    int dashes = least_dashes(missing, along, rate, cycles, course);
    while (dashes < cycles &&
           along * drift[static_cast<std::size_t>(dashes)] + rate * course.at(dashes - 1).run <
               missing) {
      ++dashes;
    }
    run_straight(runner, heading, rate, dashes, course);
    runner.position += runner.velocity * drift[static_cast<std::size_t>(cycles - dashes)];
  }

  void add(const Runner& runner, Kind kind, int turns, int dashes, double turn, double direction) {
    DashCourse& course = course_after(turns);
    InterceptPlan plan;
    plan.kind = kind;
    plan.turns = turns;
    plan.leg_turn = turns == 0 && turn != 0.0;
    plan.dashes = dashes;
    plan.turn_angle = turn;
    plan.dash_direction = direction;
    plan.self_position = runner.position;
    plan.ball_distance = soccer::distance(
        runner.position, path[static_cast<std::size_t>(turns) + static_cast<std::size_t>(dashes)]);
    plan.stamina = world.self.stamina;

    if (runner.dashes > 0) {
      const DashCourse::Dash& last = course.at(runner.dashes - 1);
      plan.stamina = last.stamina;
      plan.exhausting = last.exhausted;
      plan.dash_power = course.at(0).power;
    }

    table.plans.push_back(plan);
  }

  /// Last step up to `horizon` at which dashes along `heading` may reach the ball: it is near the
  /// line of the run and not behind the coasting agent. 0: none.
  int last_chance(Vec2 heading, double rate, int horizon) const {
    if (rate > unlimited_rate) return horizon;  // the speed limit also slows the drift to the side
    constexpr double kRounding = 1e-6;
    int step = horizon;
    for (; step > 0; --step) {
      const double reach = control_at(step) + kRounding;
      const Vec2 offset = offsets[static_cast<std::size_t>(step)];
      if (std::fabs(soccer::cross(offset, heading)) <= reach &&
          soccer::dot(offset, heading) >= -reach) {
        break;
      }
    }
    return step;
  }

  /// Dashes in one direction relative to the body, without turning.
  void omni(double direction, Vec2 heading) {
    const double rate = dash_rate(world.server(), direction);
    const int horizon = direction == 0.0 ? kInterceptHorizon : kSideDashHorizon;
    const int last = last_chance(heading, rate, std::min(horizon, most_steps));
    Runner runner(world);
    DashCourse& course = course_after(0);
    int found = 0;

    for (int step = 1; step <= last && found < kPlansPerDirection; ++step) {
      runner.dash(heading, rate, course);
      if (!reaches(runner.position, step)) continue;
      add(runner, Kind::kOmniDash, 0, step, 0.0, direction);
      ++found;
    }
  }

  void dashing_without_turn() {
    constexpr std::array<double, 8> kDirections{0.0,   45.0,  -45.0,  90.0,
                                                -90.0, 135.0, -135.0, 180.0};
    std::array<double, kDirections.size()> radians;
    for (std::size_t i = 0; i < radians.size(); ++i) {
      radians[i] = (world.self.body + kDirections[i]).radians();
    }
    std::array<Vec2, kDirections.size()> headings;
    soccer::unit_vectors(radians.data(), radians.size(), headings.data());
    for (std::size_t i = 0; i < headings.size(); ++i) omni(kDirections[i], headings[i]);
  }

  /// The ball at a step, as seen from the coasting agent.
  struct Aim {
    int step = 0;
    double distance = 0.0;
    double degrees = 0.0;  ///< direction
    double slack = 0.0;    ///< a body within these degrees of the direction points at the ball
  };
  using AimList = base::FixedList<Aim, kInterceptHorizon>;

  double farthest(int step, double rate) const {
    return run[static_cast<std::size_t>(step - 1)] * rate + control_at(step);
  }

  static double slack_of(double reach, double distance) {
    constexpr double kMinSlack = 5.0;
    constexpr double kMinRatio = 0.087;  // below the sine of kMinSlack
    if (distance <= reach) return 180.0;
    const double ratio = reach / distance;
    if (ratio < kMinRatio) return kMinSlack;
    return std::max(kMinSlack, math::to_degrees(math::asin(ratio)));
  }

  /// Steps at which a run in a straight line may get to the ball.
  AimList aims() const {
    const double rate = std::max(forward_rate, backward_rate);
    AimList out;
    base::FixedList<Vec2, AimList::capacity()> near;
    for (int step = 1; step <= most_steps; ++step) {
      const Vec2 offset = offsets[static_cast<std::size_t>(step)];
      const double far = farthest(step, rate);
      if (offset.squared_length() > far * far) continue;
      const double distance = offset.length();
      out.push_back({step, distance, 0.0, slack_of(control_at(step), distance)});
      near.push_back(offset);
    }
    std::array<double, AimList::capacity()> degrees;
    soccer::directions(near.begin(), near.size(), degrees.data());
    for (std::size_t i = 0; i < out.size(); ++i) out[i].degrees = degrees[i];
    return out;
  }

  /// Turns until the body (or back) points at the ball, then dashes. False when this does not reach
  /// it.
  bool turn_and_dash(const Aim& aim, bool backward) {
    const int step = aim.step;
    const Vec2 target = path[static_cast<std::size_t>(step)];
    const double rate = backward ? backward_rate : forward_rate;
    if (aim.distance > farthest(step, rate)) return false;

    const AngleDeg heading = aim.distance > 1e-3 ? AngleDeg(aim.degrees) : world.self.body;
    const double desired_turn =
        ((backward ? heading + 180.0 : heading) - world.self.body).degrees();

    double missing = std::fabs(desired_turn);
    int turns = 0;
    while (missing > aim.slack && turns < std::min(step, kMaxTurns)) {
      missing -= coasting[static_cast<std::size_t>(turns)].max_turn;
      ++turns;
    }

    if (missing > aim.slack || turns == 0) return false;  // without a turn it is an omni dash
    missing = std::max(0.0, missing);
    const double turn = desired_turn < 0.0 ? desired_turn + missing : desired_turn - missing;
    const int dashes = step - turns;

    const Coasting& turned = coasting[static_cast<std::size_t>(turns)];
    Runner runner(world.self_type(), turned.position, turned.velocity);
    const Vec2 unit = polar(1.0, world.self.body + turn + (backward ? 180.0 : 0.0));
    if (dashes > 0) dash_toward(target, runner, unit, rate, dashes, course_after(turns));

    if (!reaches(runner.position, step)) return false;
    add(runner, backward ? Kind::kTurnBackwardDash : Kind::kTurnForwardDash, turns, dashes, turn,
        backward ? 180.0 : 0.0);
    return true;
  }

  /// Turns the body with the first dash, toward the ball position at `step`.
  bool turn_while_dashing(int step) {
    const Vec2 target = path[static_cast<std::size_t>(step)];
    const double reach = control_at(step);
    const double drifting = drift[static_cast<std::size_t>(step)];
    const Vec2 offset = offsets[static_cast<std::size_t>(step)];
    const double distance = offset.length();
    if (distance > run[static_cast<std::size_t>(step)] + reach || distance < reach) return false;

    DashCourse& course = course_after(0);
    const double power = course.at(0).power;
    std::optional<LegTurn> turn;
    double angle = (AngleDeg::of(offset) - world.self.body).degrees();
    // The second time from where the first dash drifts to.
    for (int i = 0; i < 2; ++i) {
      turn = useful_leg_turn(world, angle, power, true);
      if (!turn) return false;
      const Vec2 rest = offset - turn->acceleration * drifting;
      if (i == 0) angle = (AngleDeg::of(rest) - world.self.body).degrees();
    }

    Runner runner(world);
    runner.push(turn->acceleration);
    ++runner.dashes;
    const Vec2 unit = polar(1.0, world.self.body + angle);
    runner.dash_up_to(target, unit, forward_rate, step - 1, course);

    if (!reaches(runner.position, step)) return false;
    add(runner, Kind::kTurnForwardDash, 0, step, angle, 0.0);
    return true;
  }

  void turning_while_dashing() {
    int found = 0;
    for (int step = 1; step <= most_steps && found < kPlansPerDirection; ++step) {
      if (turn_while_dashing(step)) ++found;
    }
  }

  void turning(const AimList& aims, bool backward) {
    int found = 0;
    for (const Aim& aim : aims) {
      if (turn_and_dash(aim, backward) && ++found == kPlansPerTurn) return;
    }
  }
};

// Plans of equal rank keep the order of the search, which std::sort leaves to the library; and
// std::stable_sort allocates.
void rank_plans(InterceptTable& table) {
  const auto before = [](const InterceptPlan& a, const InterceptPlan& b) {
    const auto rank = [](const InterceptPlan& plan) {
      return std::tuple(plan.steps(), plan.turns, -plan.stamina);
    };
    return rank(a) < rank(b);
  };
  for (auto next = table.plans.begin(); next != table.plans.end(); ++next) {
    std::rotate(std::upper_bound(table.plans.begin(), next, *next, before), next, next + 1);
  }
}

}  // namespace

void plan_self_intercept(const WorldModel& world, const BallPath& path, int most_steps,
                         InterceptTable& table) {
  table.plans.clear();
  table.self_steps = table.self_exhausting_steps = kNever;
  if (world.self.kickable) {
    table.self_steps = 0;
    return;
  }
  if (most_steps == 0) return;

  Search search(world, path, most_steps, table);
  search.dashing_without_turn();
  const Search::AimList aims = search.aims();
  search.turning(aims, false);
  search.turning(aims, true);
  if (world.leg_dashes) search.turning_while_dashing();

  rank_plans(table);
  for (const InterceptPlan& plan : table.plans) {
    int& steps = plan.exhausting ? table.self_exhausting_steps : table.self_steps;
    steps = std::min(steps, plan.steps());
  }
}

}  // namespace cls::player
