// The ball's belief between and at looks.
#include "proxy/tracking/ball_tracking.h"

#include <algorithm>
#include <cmath>

#include "proxy/tracking/observed_object.h"
#include "proxy/tracking/visibility.h"
#include "soccer/math.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;
using soccer::Observation;
using soccer::ObservedKind;
using soccer::SenseBody;
using soccer::Vec2;

constexpr double kDiscDeviation = 0.408248290463863;  // see self_motion.cpp

double square(double x) { return x * x; }

/// A push that acts in the coming step: what it adds to the velocity and how surely.
struct Push {
  Vec2 acceleration;
  double deviation = 0.0;  ///< per axis
};

/// Simulation model 4.4.
Push own_kick(const WorldModel& world, const soccer::Kick& kick) {
  const SelfState& self = world.self;
  const BallState& ball = world.ball;
  const soccer::ServerParams& server = world.server();
  const soccer::PlayerType& type = world.self_type();
  const double power = std::clamp(kick.power, server.minpower, server.maxpower);
  const double direction = std::clamp(kick.direction, server.minmoment, server.maxmoment);
  const Vec2 offset = ball.position - self.position;
  const double turn = (soccer::AngleDeg::of(offset) - self.body).abs() / 180.0;
  const double gap = (offset.length() - type.player_size - server.ball_size) / type.kickable_margin;
  const double effect = power * type.kick_power_rate * (1.0 - 0.25 * turn - 0.25 * gap);
  const double position_rate = 0.5 + 0.25 * (turn + gap);
  const double speed_rate =
      0.5 + 0.5 * ball.velocity.length() / (server.ball_speed_max * server.ball_decay);
  const double radius = type.kick_rand * power / server.maxpower * (position_rate + speed_rate);
  // The ball's place was itself only believed; that blurs the effect a little more.
  const double deviation = std::fabs(radius) * kDiscDeviation + 0.02 * std::fabs(effect);
  return {soccer::polar(effect, self.body + direction), deviation};
}

/// Whether a tackle touched the ball is not told, so it widens the belief as much as it moves it.
Push own_tackle(const WorldModel& world, const soccer::Tackle& tackle) {
  const soccer::ServerParams& server = world.server();
  const double p = world.self.tackle_probability;
  const double angle = math::normalize_degrees(tackle.angle_or_power);
  const double reach =
      server.max_back_tackle_power +
      (server.max_tackle_power - server.max_back_tackle_power) * (1.0 - std::fabs(angle) / 180.0);
  const double effect = reach * server.tackle_power_rate;
  return {soccer::polar(p * effect, world.self.body + angle),
          std::max(0.3, effect) * std::sqrt(std::max(p * (1.0 - p), 0.02))};
}

Push own_push(const WorldModel& world, const SenseBody& sense) {
  const SentCommands& sent = world.self_tracker.sent;
  const soccer::CommandCounts& before = world.self.counts;
  if (sent.kick && sense.counts.kick > before.kick) return own_kick(world, *sent.kick);
  if (sent.tackle && sense.tackle_count > world.self.tackle_count) {
    return own_tackle(world, *sent.tackle);
  }
  return {};
}

/// Somebody else close enough to have kicked in the step that is over.
bool others_could_kick(const WorldModel& world) {
  constexpr double kReach = 1.6;  // kickable area and a stride
  const Vec2 ball = world.ball.position;
  for (const PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (const PlayerState& player : *list) {
      if (player.pos_count > 10) continue;
      const double blur = 0.5 * std::sqrt(player.covariance[0] + player.covariance[5]);
      if (soccer::distance(player.position, ball) < kReach + std::min(blur, 1.5)) return true;
    }
  }
  return false;
}

void step(MovingBelief& state, const soccer::ServerParams& server, const Push& push) {
  if (!push.acceleration.is_zero()) {
    Vec2 a = push.acceleration;
    if (a.length() > server.ball_accel_max) a = soccer::with_length(a, server.ball_accel_max);
    Vec2 v = Vec2{state.mean[2], state.mean[3]} + a;
    if (v.length() > server.ball_speed_max) v = soccer::with_length(v, server.ball_speed_max);
    state.mean[2] = v.x;
    state.mean[3] = v.y;
  }
  const double speed = Vec2{state.mean[2], state.mean[3]}.length();
  const double noise = square(server.ball_rand * speed * kDiscDeviation) + square(push.deviation);
  const double decay = server.ball_decay;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.mean[axis] += state.mean[axis + 2];
    state.mean[axis + 2] *= decay;
  }
  // z' = F z with x' = x + v, v' = decay v, and the noise in v before the move.
  const auto at = [&](std::size_t r, std::size_t c) -> double& { return state.at(r, c); };
  for (std::size_t c = 0; c < 4; ++c) {
    at(0, c) += at(2, c);
    at(1, c) += at(3, c);
    at(2, c) *= decay;
    at(3, c) *= decay;
  }
  for (std::size_t r = 0; r < 4; ++r) {
    at(r, 0) += at(r, 2);
    at(r, 1) += at(r, 3);
    at(r, 2) *= decay;
    at(r, 3) *= decay;
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    at(axis, axis) += noise;
    at(axis, axis + 2) += noise * decay;
    at(axis + 2, axis) += noise * decay;
    at(axis + 2, axis + 2) += noise * decay * decay;
  }
}

/// A kick nobody told us about, some time in the last `cycles`: both place and velocity may differ.
void loosen(MovingBelief& state, int cycles) {
  constexpr double kKickDeviation = 1.3;
  const double n = std::min(cycles, 10);
  const double velocity = square(kKickDeviation);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.at(axis, axis) += velocity * n * n;
    state.at(axis + 2, axis + 2) += velocity;
    state.at(axis, axis + 2) += 0.8 * velocity * n;
    state.at(axis + 2, axis) += 0.8 * velocity * n;
  }
}

void forget(WorldModel& world) {
  world.ball_tracker.tracked = false;
  world.ball.pos_count = world.ball.relative_pos_count = world.ball.vel_count = kNever;
}

void see_ball(WorldModel& world, const Observation& seen) {
  BallState& ball = world.ball;
  BallTracker& tracker = world.ball_tracker;
  const Viewpoint view = viewpoint(world);
  const Sight sight = sight_of(view, world.parameters->object_distances, seen);
  constexpr double kSurprise = 12.0;  // squared deviations; about one in 400 looks by chance
  const bool told = seen.detail >= soccer::ObservedDetail::kMotion;
  if (tracker.tracked && misfit(tracker.state, sight).squared > kSurprise) {
    tracker.pushed = true;
    loosen(tracker.state, std::max(1, ball.seen_pos_count));
    if (misfit(tracker.state, sight).squared > kSurprise) tracker.tracked = false;
  }
  if (tracker.tracked) {
    observe(tracker.state, view, sight, seen);
  } else {
    constexpr double kUnknownVelocity = 0.5;
    tracker.state = first_belief(view, sight, seen, {}, square(kUnknownVelocity));
    tracker.tracked = true;
  }
  publish_ball(world);
  ball.seen_position = ball.position;
  ball.seen_relative_position = ball.relative_position;
  ball.pos_count = ball.seen_pos_count = ball.relative_pos_count = 0;
  if (told) {
    ball.seen_velocity = ball.velocity;
    ball.vel_count = ball.seen_vel_count = 0;
  }
  ball.ghost_count = 0;
  ball.lost_count = 0;
}

/// The look went where the ball should be and did not find it.
void miss_ball(WorldModel& world) {
  BallState& ball = world.ball;
  if (!world.ball_tracker.tracked) return;
  if (!must_be_visible(world, ball.position, ball.position_deviation)) return;
  ++ball.ghost_count;
  constexpr int kTakenForGone = 2;
  if (ball.ghost_count >= kTakenForGone) forget(world);
}

}  // namespace

void publish_ball(WorldModel& world) {
  const MovingBelief& state = world.ball_tracker.state;
  BallState& ball = world.ball;
  ball.position = {state.mean[0], state.mean[1]};
  ball.velocity = {state.mean[2], state.mean[3]};
  ball.relative_position = ball.position - world.self.position;
  ball.position_deviation = std::sqrt(std::max(state.at(0, 0), state.at(1, 1)));
  ball.velocity_deviation = std::sqrt(std::max(state.at(2, 2), state.at(3, 3)));
}

void advance_ball(WorldModel& world, const SenseBody& sense, int cycles) {
  BallState& ball = world.ball;
  for (int* age :
       {&ball.pos_count, &ball.relative_pos_count, &ball.seen_pos_count, &ball.heard_pos_count,
        &ball.vel_count, &ball.seen_vel_count, &ball.heard_vel_count}) {
    *age = std::min(kNever, *age + cycles);
  }
  if (!world.ball_tracker.tracked || ball.ghost_count > 0 || !ball.position_valid()) {
    ball.lost_count = std::min(kNever, ball.lost_count + cycles);
  }
  if (!world.ball_tracker.tracked) return;
  MovingBelief& state = world.ball_tracker.state;
  Push push = own_push(world, sense);
  if (push.acceleration.is_zero() && others_could_kick(world)) {
    constexpr double kMaybeKicked = 0.35;
    push.deviation = kMaybeKicked;
  }
  for (int i = 0; i < cycles; ++i) step(state, world.server(), i == 0 ? push : Push{});
  if (sense.collided_with_ball) {
    constexpr double kPushedApart = 0.3;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      state.at(axis, axis) += square(kPushedApart);
      state.mean[axis + 2] *= -0.1;
      state.at(axis + 2, axis + 2) += square(0.1);
    }
  }
  publish_ball(world);
}

void observe_ball(WorldModel& world, const soccer::See& see) {
  const auto seen = std::find_if(see.objects.begin(), see.objects.end(), [](const Observation& o) {
    return (o.kind == ObservedKind::kBall || o.kind == ObservedKind::kCloseBall) &&
           o.detail != soccer::ObservedDetail::kDirection;
  });
  if (seen != see.objects.end()) {
    see_ball(world, *seen);
  } else {
    miss_ball(world);
  }
}

void place_ball(WorldModel& world, Vec2 position, double deviation) {
  MovingBelief& state = world.ball_tracker.state;
  state = {};
  state.mean = {position.x, position.y, 0.0, 0.0};
  constexpr double kAtRest = 0.01;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    state.at(axis, axis) = square(deviation);
    state.at(axis + 2, axis + 2) = square(kAtRest);
  }
  world.ball_tracker.tracked = true;
  publish_ball(world);
}

Vec2 ball_after(Vec2 position, Vec2 velocity, int cycles, double decay) {
  for (int i = 0; i < cycles; ++i) {
    position += velocity;
    velocity *= decay;
  }
  return position;
}

}  // namespace cls::proxy
