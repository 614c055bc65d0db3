// The agent's own ways to the ball.
#include <algorithm>
#include <cmath>

#include "proxy/world/chances.h"
#include "proxy/world/dash_model.h"
#include "proxy/world/intercept.h"
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

/// A run of the agent, step by step.
struct Runner {
  const soccer::ServerParams& server;
  const soccer::PlayerType& type;
  Stamina strength;
  Vec2 position;
  Vec2 velocity;
  double first_power = -1.0;
  bool exhausted = false;

  explicit Runner(const WorldModel& world)
      : server(world.server()),
        type(world.self_type()),
        strength{world.self.stamina, world.self.effort, world.self.recovery, world.self.capacity},
        position(world.self.position),
        velocity(world.self.velocity) {}

  void coast() {
    position += velocity;
    velocity *= type.player_decay;
    strength.step(server, type, 0.0);
  }

  /// One dash of full power along the unit vector `heading`, `rate` the share that acts.
  void dash(Vec2 heading, double rate) {
    const double power = std::min(server.max_dash_power, strength.stamina + type.extra_stamina);
    if (first_power < 0.0) first_power = power;
    velocity += heading * std::fabs(strength.effort * power * rate * type.dash_power_rate);
    if (velocity.squared_length() > type.player_speed_max * type.player_speed_max) {
      velocity = soccer::with_length(velocity, type.player_speed_max);
    }
    position += velocity;
    velocity *= type.player_decay;
    strength.step(server, type, power);
    exhausted |= strength.stamina <= server.recover_dec_thr * server.stamina_max;
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

struct Search {
  const WorldModel& world;
  const BallPath& path;
  InterceptTable& table;
  /// How far full dashes forward carry from rest, by their number; and how far the present velocity
  /// carries by itself.
  std::array<double, kInterceptHorizon + 1> run{};
  std::array<double, kInterceptHorizon + 1> drift{};

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

  void add(const Runner& runner, Kind kind, int turns, int dashes, double turn, double direction) {
    InterceptPlan plan;
    plan.kind = kind;
    plan.turns = turns;
    plan.dashes = dashes;
    plan.exhausting = runner.exhausted;
    plan.turn_angle = turn;
    plan.dash_power = std::max(0.0, runner.first_power);
    plan.dash_direction = direction;
    plan.self_position = runner.position;
    plan.ball_distance =
        soccer::distance(runner.position, path[static_cast<std::size_t>(turns + dashes)]);
    plan.stamina = runner.strength.stamina;
    table.plans.push_back(plan);
  }

  /// Dashes in one direction off the body, without turn.
  void omni(double direction) {
    Runner runner(world);
    const Vec2 heading = polar(1.0, world.self.body + direction);
    const double rate = dash_direction_rate(world.server(), direction);
    int found = 0;
    for (int step = 1; step <= kInterceptHorizon && found < kPlansPerDirection; ++step) {
      runner.dash(heading, rate);
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
    while (missing > slack && turns < step) {
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
        runner.dash(unit, rate);
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
