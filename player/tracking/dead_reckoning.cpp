// Dead reckoning: pose, velocity and neck after the last step, from sense_body and own commands.
#include <algorithm>
#include <cmath>

#include "player/tracking/tracking.h"
#include "player/world/leg_dash.h"
#include "player/world/running.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

constexpr double kUniformVariance = 1.0 / 12.0;  // of a uniform distribution of width 1
// Position uncertainty after a collision: about one body radius.
constexpr double kCollisionDeviation = 0.3;
constexpr double kDegreesPerRadian = 180.0 / math::kPi;

struct Executed {
  bool turn = false;
  bool dash = false;
  bool leg_dash = false;
  bool move = false;
  bool turn_neck = false;
  bool unknown_turn = false;  ///< the server executed a turn that the agent did not send
};

Executed executed(const SelfTracker& tracker, const soccer::CommandCounts& before,
                  const soccer::CommandCounts& after) {
  const SentCommands& sent = tracker.sent;
  return {.turn = after.turn > before.turn && sent.turn,
          .dash = after.dash > before.dash && sent.dash,
          .leg_dash = after.dash > before.dash && sent.leg_dash,
          .move = after.move > before.move && sent.move,
          .turn_neck = after.turn_neck > before.turn_neck && sent.turn_neck,
          .unknown_turn = (after.turn > before.turn && !sent.turn) || after.turn > before.turn + 1};
}

/// Turns the body estimate; returns the variance of the noise, which the caller adds.
double turn_body(WorldModel& world, double turned) {
  Gaussian<3>& pose = world.self_tracker.pose;
  pose.mean[2] = math::normalize_degrees(pose.mean[2] + turned);
  const double half_width = world.server().player_rand * std::fabs(turned);
  return half_width * half_width / 3.0;
}

/// Applies the executed turn to the body estimate.
void turn_body(WorldModel& world, const Executed& done) {
  SelfTracker& tracker = world.self_tracker;
  Gaussian<3>& pose = tracker.pose;

  if (done.turn) {
    const soccer::ServerParams& server = world.server();
    const double moment =
        soccer::between(tracker.sent.turn->moment, server.minmoment, server.maxmoment);
    const double turned =
        moment / (1.0 + world.self_type().inertia_moment * world.self.velocity.length());
    pose.at(2, 2) += turn_body(world, turned);
  }
  if (done.unknown_turn) pose.at(2, 2) += 180.0 * 180.0 / 3.0;
}

/// Neck angle: the sum of own turns is exact; head_angle, truncated to whole degrees, verifies it.
/// On a mismatch (lost or unknown commands) uses head_angle and increases the body variance.
AngleDeg neck_after(WorldModel& world, const Executed& done, int head_angle) {
  double neck = world.self.neck.degrees();

  if (done.turn_neck) {
    const soccer::ServerParams& server = world.server();
    const double moment = soccer::between(world.self_tracker.sent.turn_neck->moment,
                                          server.minneckmoment, server.maxneckmoment);
    neck = soccer::between(neck + moment, server.minneckang, server.maxneckang);
  }

  // Truncated toward zero: the true angle is up to one degree larger; the server's radians may
  // round to either side at the border.
  constexpr double kSlack = 1e-3;
  const double low = head_angle > 0 ? head_angle - kSlack : head_angle - 1.0 - kSlack;
  const double high = head_angle < 0 ? head_angle + kSlack : head_angle + 1.0 + kSlack;
  if (neck >= low && neck <= high) return AngleDeg(neck);

  // Neck angles are whole degrees; the reported one is right in about four of five cases.
  world.self_tracker.pose.at(2, 2) += 0.25;
  return AngleDeg(head_angle);
}

/// Acceleration of the executed dash.
Vec2 dash_acceleration(const WorldModel& world) {
  const soccer::Dash& dash = *world.self_tracker.sent.dash;
  const soccer::ServerParams& server = world.server();

  const double power = soccer::between(dash.power, server.min_dash_power, server.max_dash_power);
  double direction = soccer::between(dash.direction, server.min_dash_angle, server.max_dash_angle);
  if (server.dash_angle_step > math::kEps) {
    direction = math::quantize(direction, server.dash_angle_step);
  }

  const double rate = dash_rate(server, direction);
  const double length =
      std::fabs(world.self.effort * power * rate * world.self_type().dash_power_rate);
  const AngleDeg heading(world.self_tracker.pose.mean[2] + direction + (power < 0.0 ? 180.0 : 0.0));

  return polar(length, heading);
}

struct Heading {
  double degrees = 0.0;   ///< global direction of the velocity
  double variance = 0.0;  ///< square degrees
  double body_covariance = 0.0;
};

constexpr double kNoPrediction = 180.0 * 180.0;

/// Interval of a direction that is truncated to whole degrees.
struct SensedDirection {
  double middle;
  double half;

  explicit SensedDirection(int degrees) {
    const double low = degrees > 0 ? degrees : degrees - 1.0;
    const double high = degrees < 0 ? degrees : degrees + 1.0;
    middle = 0.5 * (low + high);
    half = 0.5 * (high - low);
  }
};

/// Fuses the predicted velocity direction with the sensed one, which is relative to the face and
/// truncated to whole degrees. Applies the implied body correction to the pose.
Heading fuse_heading(Gaussian<3>& pose, double predicted, double predicted_variance, double neck,
                     int sensed_direction) {
  const auto [middle, half] = SensedDirection(sensed_direction);

  // y = heading - body - neck - middle: estimated as offset +- deviation, observed within +- half.
  const double body_variance = pose.at(2, 2);
  // Without noise both can be zero, and their ratios NaN.
  const double variance = std::max(body_variance + predicted_variance, 1e-12);
  const double offset = math::normalize_degrees(predicted - pose.mean[2] - neck - middle);
  const double deviation = std::sqrt(variance);

  if (predicted_variance >= kNoPrediction || std::fabs(offset) > half + 5.0 * deviation) {
    // No prediction, or a wrong one (collision, unknown command): use the sensed value only.
    return {math::normalize_degrees(pose.mean[2] + neck + middle),
            body_variance + 4.0 * half * half * kUniformVariance, body_variance};
  }

  const Moments truncated_moments = truncated({offset, variance}, -half, half);
  const double shift = truncated_moments.mean - offset;
  const double reduction = variance - truncated_moments.variance;
  const double heading_share = predicted_variance / variance;
  const double body_share = body_variance / variance;

  Heading out;
  out.degrees = predicted + heading_share * shift;
  out.variance = predicted_variance - heading_share * heading_share * reduction;
  out.body_covariance = heading_share * body_share * reduction;

  const VecN<3> h{0.0, 0.0, -1.0};
  const VecN<3> gain = covariance_with(pose, h);
  // y changes with -body: distribute the shift to the body and, by covariance, to the position.
  rank_one_update(pose, gain, body_variance, shift * body_share,
                  reduction * body_share * body_share);
  pose.mean[2] = math::normalize_degrees(pose.mean[2]);
  return out;
}

/// The same after a two-leg dash. It follows the body before its turn, so body and velocity share
/// the error of that; the sensed direction, relative to the face after the turn, shows the noise of
/// the turn (`turn_variance`) and of the movement (`movement_variance`).
Heading fuse_leg_heading(Gaussian<3>& pose, double turn_variance, double predicted,
                         double movement_variance, double neck, int sensed_direction) {
  const SensedDirection sensed(sensed_direction);
  const double before = pose.at(2, 2);
  const double variance = std::max(turn_variance + movement_variance, 1e-12);
  const double offset = math::normalize_degrees(predicted - pose.mean[2] - neck - sensed.middle);

  if (movement_variance >= kNoPrediction ||
      std::fabs(offset) > sensed.half + 5.0 * std::sqrt(variance)) {
    pose.at(2, 2) += turn_variance;
    return fuse_heading(pose, predicted, kNoPrediction, neck, sensed_direction);
  }

  const Moments inside = truncated({offset, variance}, -sensed.half, sensed.half);
  const double shift = inside.mean - offset;
  const double reduction = variance - inside.variance;
  const double heading_share = movement_variance / variance;
  const double body_share = turn_variance / variance;

  pose.mean[2] = math::normalize_degrees(pose.mean[2] - body_share * shift);
  pose.at(2, 2) = before + turn_variance - body_share * body_share * reduction;
  return {predicted + heading_share * shift,
          before + movement_variance - heading_share * heading_share * reduction,
          before + heading_share * body_share * reduction};
}

/// Fuses the sensed speed (rounded to 0.01) with the predicted speed.
Moments fuse_speed(double sensed, Moments predicted) {
  constexpr double kHalfStep = 0.005;
  const double low = std::max(0.0, sensed - kHalfStep);
  const double high = sensed + kHalfStep;

  const double outside = std::max(low - predicted.mean, predicted.mean - high);
  if (outside <= 0.0 && predicted.variance < 1e-10) return predicted;
  if (outside > 5.0 * std::sqrt(predicted.variance)) {
    if (sensed <= 0.0) return {0.0, kHalfStep * kHalfStep / 9.0};
    return {sensed, 4.0 * kHalfStep * kHalfStep * kUniformVariance};
  }

  return truncated(predicted, low, high);
}

/// Adds a displacement of `length` (variance `length_variance`) along `heading`.
void displace(Gaussian<3>& pose, double length, double length_variance, const Heading& heading) {
  const math::SinCos direction = math::sincos(math::to_radians(heading.degrees));
  pose.mean[0] += length * direction.cos;
  pose.mean[1] += length * direction.sin;

  // Across the heading: meters per degree of heading error.
  const double across = length / kDegreesPerRadian;
  const double nx = -direction.sin * across;
  const double ny = direction.cos * across;
  const double v = heading.variance;
  pose.at(0, 0) += nx * nx * v + direction.cos * direction.cos * length_variance;
  pose.at(1, 1) += ny * ny * v + direction.sin * direction.sin * length_variance;
  const double mixed = nx * ny * v + direction.cos * direction.sin * length_variance;

  // The heading error correlates with the body error and, through it, with the position error.
  const double share = pose.at(2, 2) > 0.0 ? heading.body_covariance / pose.at(2, 2) : 0.0;
  const double xt = pose.at(0, 2) * share;
  const double yt = pose.at(1, 2) * share;
  pose.at(0, 0) += 2.0 * nx * xt;
  pose.at(1, 1) += 2.0 * ny * yt;

  const double xy = pose.at(0, 1) + mixed + nx * yt + ny * xt;
  pose.at(0, 1) = pose.at(1, 0) = xy;
  pose.at(0, 2) += nx * heading.body_covariance;
  pose.at(1, 2) += ny * heading.body_covariance;
  pose.at(2, 0) = pose.at(0, 2);
  pose.at(2, 1) = pose.at(1, 2);
}

/// Adds the uncertainty of one unobserved cycle.
void add_unknown_cycle(Gaussian<3>& pose, const soccer::PlayerType& type) {
  const double variance = type.player_speed_max * type.player_speed_max / 2.0;
  pose.at(0, 0) += variance;
  pose.at(1, 1) += variance;
}

void set_position(SelfTracker& tracker, Vec2 position) {
  Gaussian<3>& pose = tracker.pose;
  const double body_variance = pose.at(2, 2);
  pose.covariance = {};
  pose.mean[0] = position.x;
  pose.mean[1] = position.y;
  pose.at(0, 0) = pose.at(1, 1) = 1e-4;
  pose.at(2, 2) = body_variance;
}

// The sensed velocity is reversed and reduced to a tenth; the motion before the collision followed
// the old velocity.
void collide(Gaussian<3>& pose, Vec2 velocity) {
  pose.mean[0] += 0.5 * velocity.x;
  pose.mean[1] += 0.5 * velocity.y;
  const double spread = kCollisionDeviation + 0.3 * velocity.length();
  pose.at(0, 0) += spread * spread;
  pose.at(1, 1) += spread * spread;
}

}  // namespace

void advance_self(WorldModel& world, const soccer::SenseBody& sense, int cycles) {
  SelfState& self = world.self;
  SelfTracker& tracker = world.self_tracker;
  Gaussian<3>& pose = tracker.pose;
  const Executed done = executed(tracker, self.counts, sense.counts);
  const double decay = world.self_type().player_decay;
  const bool collided =
      sense.collided_with_ball || sense.collided_with_player || sense.collided_with_post;

  Vec2 before_noise = self.velocity;
  DashEffect legs;
  if (done.dash) before_noise += dash_acceleration(world);
  if (done.leg_dash) {
    legs = leg_dash_effect(world, AngleDeg(pose.mean[2]), *tracker.sent.leg_dash);
    before_noise += legs.acceleration;
  }
  turn_body(world, done);
  self.neck = neck_after(world, done, sense.head_angle);

  // A dash follows the body and carries no information about it; without a dash the direction
  // persists.
  const double rand = world.server().player_rand * kDiscDeviation;
  const double noise_degrees = rand * kDegreesPerRadian;
  const double noise_variance = noise_degrees * noise_degrees;
  const bool steady = !collided && !done.dash && !done.unknown_turn && !before_noise.is_zero();
  const double predicted = soccer::direction_degrees(before_noise);
  const Heading heading =
      done.leg_dash
          ? fuse_leg_heading(pose, turn_body(world, legs.turn), predicted,
                             steady ? noise_variance : kNoPrediction, self.neck.degrees(),
                             sense.speed_direction)
          : fuse_heading(pose, predicted,
                         steady ? noise_variance + tracker.heading_variance : kNoPrediction,
                         self.neck.degrees(), sense.speed_direction);

  const double expected = before_noise.length() * decay;
  const double deviation = expected * (rand + (done.dash || done.leg_dash ? 0.01 : 0.0));
  const Moments speed = fuse_speed(
      sense.speed, collided ? Moments{sense.speed, 1.0} : Moments{expected, deviation * deviation});

  tracker.heading_variance = heading.variance;
  tracker.heading_follows_body =
      pose.at(2, 2) > 0.0 ? heading.body_covariance / pose.at(2, 2) : 0.0;

  if (collided) {
    collide(pose, before_noise);
  } else {
    displace(pose, speed.mean / decay, speed.variance / (decay * decay), heading);
  }

  for (int lost = 1; lost < cycles; ++lost) add_unknown_cycle(pose, world.self_type());
  if (done.move) set_position(tracker, {tracker.sent.move->x, tracker.sent.move->y});

  self.velocity = soccer::polar_degrees(speed.mean, heading.degrees);
  self.vel_count = 0;
  if (done.move) self.pos_count = 0;
}

}  // namespace cls::player
