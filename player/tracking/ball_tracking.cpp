// Predicts the ball estimate between see messages and updates it by them.
#include "player/tracking/tracking.h"

#include <algorithm>
#include <cmath>

#include "player/tracking/observed_object.h"
#include "player/world/view_cone.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

using soccer::Observation;
using soccer::ObservedKind;
using soccer::SenseBody;

/// Acceleration of the ball in the next step, and its uncertainty.
struct Push {
  Vec2 acceleration;
  double deviation = 0.0;  ///< per axis
};

/// docs/spec/simulation-model.md 4.4.
Push own_kick(const WorldModel& world, const soccer::Kick& kick) {
  const SelfState& self = world.self;
  const BallState& ball = world.ball;
  const soccer::ServerParams& server = world.server();
  const soccer::PlayerType& type = world.self_type();

  const double power = soccer::between(kick.power, server.minpower, server.maxpower);
  const double direction = soccer::between(kick.direction, server.minmoment, server.maxmoment);

  const Vec2 offset = ball.position - self.position;
  const double turn = (AngleDeg::of(offset) - self.body).abs() / 180.0;
  const double gap = (offset.length() - type.player_size - server.ball_size) / type.kickable_margin;
  const double effect = power * type.kick_power_rate * (1.0 - 0.25 * turn - 0.25 * gap);

  const double position_rate = 0.5 + 0.25 * (turn + gap);
  const double speed_rate =
      0.5 + 0.5 * ball.velocity.length() / (server.ball_speed_max * server.ball_decay);
  const double radius = type.kick_rand * power / server.maxpower * (position_rate + speed_rate);

  // The estimated ball position adds some uncertainty.
  const double deviation = std::fabs(radius) * kDiscDeviation + 0.02 * std::fabs(effect);
  return {soccer::polar(effect, self.body + direction), deviation};
}

/// The server does not report whether a tackle succeeded: the mean moves by the expected effect,
/// and the variance grows accordingly.
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

/// True if another player could have kicked in the last step.
bool others_could_kick(const WorldModel& world) {
  constexpr double kReach = 1.6;  // kickable area plus one step
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

void step(ObjectEstimate& state, const soccer::ServerParams& server, const Push& push) {
  if (!push.acceleration.is_zero()) {
    const auto limited = [](Vec2 v, double max) {
      return v.length() > max ? soccer::with_length(v, max) : v;
    };
    const Vec2 v = limited(
        Vec2{state.mean[2], state.mean[3]} + limited(push.acceleration, server.ball_accel_max),
        server.ball_speed_max);
    state.mean[2] = v.x;
    state.mean[3] = v.y;
  }

  const double speed = Vec2{state.mean[2], state.mean[3]}.length();
  const double noise = square(server.ball_rand * speed * kDiscDeviation) + square(push.deviation);
  advance_estimate(state, 1.0, server.ball_decay, noise, server.ball_decay);
}

/// Inflates the covariance for an unseen kick within the last `cycles`.
void inflate_covariance(ObjectEstimate& state, int cycles) {
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

void see_ball(WorldModel& world, const Observation& seen) {
  BallState& ball = world.ball;
  BallTracker& tracker = world.ball_tracker;

  const Viewpoint view = viewpoint(world);
  const ObservedPosition observed =
      observed_position(view, world.parameters->object_distances, seen);
  constexpr double kSurprise = 12.0;  // squared Mahalanobis distance; about 1 in 400 by chance
  const bool has_motion = seen.detail >= soccer::ObservedDetail::kMotion;

  if (tracker.tracked && mahalanobis_distance(tracker.state, observed).squared > kSurprise) {
    tracker.pushed = true;
    inflate_covariance(tracker.state, std::max(1, ball.seen_pos_count));
    if (mahalanobis_distance(tracker.state, observed).squared > kSurprise) tracker.tracked = false;
  }

  if (tracker.tracked) {
    update_estimate(tracker.state, view, observed, seen);
  } else {
    constexpr double kUnknownVelocity = 0.5;
    tracker.state = initial_estimate(view, observed, seen, {}, square(kUnknownVelocity));
    tracker.tracked = true;
  }

  publish_ball(world);
  ball.seen_position = ball.position;
  ball.seen_relative_position = ball.relative_position;
  ball.pos_count = ball.seen_pos_count = ball.relative_pos_count = 0;

  if (has_motion) {
    ball.seen_velocity = ball.velocity;
    ball.vel_count = ball.seen_vel_count = 0;
  }
  ball.ghost_count = 0;
  ball.lost_count = 0;
}

/// Handles a see message without the ball.
void miss_ball(WorldModel& world) {
  BallState& ball = world.ball;
  if (!world.ball_tracker.tracked) return;
  if (!VisibleArea(world).must_show(ball.position, ball.position_deviation)) return;
  ++ball.ghost_count;
  constexpr int kMaxGhostCount = 2;
  if (ball.ghost_count < kMaxGhostCount) return;
  world.ball_tracker.tracked = false;
  ball.pos_count = ball.relative_pos_count = ball.vel_count = kNever;
}

}  // namespace

void publish_ball(WorldModel& world) {
  const ObjectEstimate& state = world.ball_tracker.state;
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

  ObjectEstimate& state = world.ball_tracker.state;
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
  const auto seen = std::ranges::find_if(see.objects, [](const Observation& o) {
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
  ObjectEstimate& state = world.ball_tracker.state;
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

}  // namespace cls::player
