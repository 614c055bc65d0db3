// Skills by geometry.
#include "training/skills/skills.h"

#include <algorithm>
#include <cmath>

#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::training {
namespace {

namespace math = soccer::math;

constexpr double kTurnCycles = 1.0;  // allowance for a turn before running
constexpr double kFullPower = 100.0;

// Position after the player's momentum of one cycle.
Vec2 next_position(const ScenePlayer& player) { return player.position + player.velocity; }

// The moment that turns the moving body by `degrees`: inertia reduces turns at speed.
double turn_moment(const ScenePlayer& player, double degrees) {
  const double inertia = 1.0 + player.type->inertia_moment * player.velocity.length();
  return std::clamp(degrees * inertia, -180.0, 180.0);
}

Vec2 unit(Vec2 v) { return soccer::with_length(v, 1.0); }

}  // namespace

double bearing_degrees(const ScenePlayer& player, Vec2 v) {
  return math::to_degrees(math::normalize_radians(soccer::direction_radians(v) - player.body));
}

PlayerCommand stand() { return soccer::Turn{0.0}; }

PlayerCommand face(const Scene& scene, Seat self, Vec2 point) {
  const ScenePlayer& me = scene.player(self);
  return soccer::Turn{turn_moment(me, bearing_degrees(me, point - next_position(me)))};
}

PlayerCommand go_to(const Scene& scene, Seat self, Vec2 point, double radius) {
  const ScenePlayer& me = scene.player(self);
  const Vec2 to = point - next_position(me);
  const double distance = to.length();
  if (distance <= radius) return stand();

  const double bearing = bearing_degrees(me, to);
  // Near targets are reached sideways and backwards, without a turn.
  if (distance < 1.5) {
    const double power = std::min(kFullPower, distance / me.type->dash_power_rate / 0.6);
    return soccer::Dash{power, bearing};
  }

  const double off = std::fabs(bearing);
  const bool ahead = off <= 12.0 || off <= math::to_degrees(math::atan2(radius, distance));
  if (!ahead) return soccer::Turn{turn_moment(me, bearing)};
  return soccer::Dash{kFullPower, 0.0};
}

BallPath ball_path(const Scene& scene) {
  BallPath path;
  Vec2 ball = scene.ball;
  Vec2 velocity = scene.ball_velocity_known ? scene.ball_velocity : Vec2{};
  for (Vec2& point : path.points) {
    ball += velocity;
    velocity *= scene.server->ball_decay;
    point = ball;
  }
  return path;
}

Meeting meeting(const Scene& scene, const BallPath& path, Seat player) {
  const ScenePlayer& runner = scene.player(player);
  const double speed = runner.type->player_speed_max * 0.95;
  const double reach = runner.kickable_area * 0.85;
  const Vec2 start = next_position(runner);

  for (int cycle = 1; cycle <= BallPath::kCycles; ++cycle) {
    const Vec2 ball = path.points[static_cast<std::size_t>(cycle - 1)];
    const double range = speed * (cycle - kTurnCycles) + reach;
    if (range > 0.0 && squared_distance(ball, start) <= range * range) return {cycle, ball};
  }

  const Vec2 end = path.points.back();
  return {BallPath::kCycles + 1 + static_cast<int>(distance(end, start) / speed), end};
}

PlayerCommand meet(const Scene& scene, Seat self, const Meeting& meeting) {
  return go_to(scene, self, meeting.point, 0.4);
}

PlayerCommand intercept(const Scene& scene, Seat self) {
  return meet(scene, self, meeting(scene, ball_path(scene), self));
}

PlayerCommand kick_to(const Scene& scene, Seat self, Vec2 point, double speed) {
  const ScenePlayer& me = scene.player(self);
  const Vec2 to_ball = scene.ball - me.position;
  const double off =
      std::fabs(math::normalize_radians(soccer::direction_radians(to_ball) - me.body)) / math::kPi;

  const double gap = (to_ball.length() - me.type->player_size - scene.server->ball_size) /
                     me.type->kickable_margin;
  const double rate = me.type->kick_power_rate * (1.0 - 0.25 * off - 0.25 * gap);
  const double strongest = scene.server->maxpower * rate;

  const Vec2 velocity = scene.ball_velocity_known ? scene.ball_velocity : Vec2{};
  const Vec2 axis = unit(point - scene.ball);
  Vec2 push = axis * speed - velocity;

  if (push.length() > strongest) {
    // The fastest velocity along the axis that one kick can give; else the kick that brakes most.
    const double along = dot(velocity, axis);
    const double aside = cross(axis, velocity);
    const double rest = strongest * strongest - aside * aside;
    push = rest > 0.0 ? axis * (along + std::sqrt(rest)) - velocity
                      : soccer::with_length(push, strongest);
  }

  return soccer::Kick{push.length() / rate, bearing_degrees(me, push)};
}

namespace {

// How far the player comes along `axis` in a cycle without a dash and `dashes` with one.
double run_length(const ScenePlayer& player, Vec2 axis, int dashes) {
  const double push = kFullPower * player.type->dash_power_rate * player.effort;
  double speed = dot(player.velocity, axis);
  double length = speed;
  for (int i = 0; i < dashes; ++i) {
    speed = std::min(speed * player.type->player_decay + push, player.type->player_speed_max);
    length += speed;
  }
  return length;
}

// Ball speed with which the ball is within reach again, in front of the player, after a kick and
// two dashes.
double dribble_speed(const Scene& scene, const ScenePlayer& me, Vec2 axis) {
  constexpr int kDashes = 2;
  const double decay = scene.server->ball_decay;
  const double rolled = (1.0 - decay * decay * decay) / (1.0 - decay);
  const double ahead = dot(scene.ball - me.position, axis);
  const double wanted = run_length(me, axis, kDashes) + 0.7 * me.kickable_area;
  return std::max(0.1, (wanted - ahead) / rolled);
}

}  // namespace

PlayerCommand dribble_to(const Scene& scene, Seat self, Vec2 point) {
  if (!can_kick(scene, self)) return intercept(scene, self);
  const ScenePlayer& me = scene.player(self);
  const Vec2 way = point - me.position;
  if (way.length() < 0.5) return stand();

  const double bearing = bearing_degrees(me, way);
  if (std::fabs(bearing) > 20.0) {
    // The ball must not roll away while the body turns.
    if (scene.ball_velocity.length() > 0.25) return kick_to(scene, self, scene.ball, 0.0);
    return soccer::Turn{turn_moment(me, bearing)};
  }

  const Vec2 next_ball = scene.ball + scene.ball_velocity;
  const Vec2 next_me = next_position(me) + unit(way) * 0.6;
  const bool stays_close = distance(next_ball, next_me) < me.kickable_area * 0.9;
  if (stays_close && dot(next_ball - next_me, way) > 0.0) return soccer::Dash{kFullPower, bearing};

  const double speed = std::min(dribble_speed(scene, me, unit(way)), way.length());
  return kick_to(scene, self, me.position + unit(way) * 10.0, speed);
}

double lane_gap(const Scene& scene, Vec2 from, Vec2 point) {
  const Vec2 lane = point - from;
  const double length = lane.length();
  double gap = math::kPi;

  for (Seat seat = soccer::kPlayersPerTeam; seat < kSeats; ++seat) {
    const ScenePlayer& player = scene.player(seat);
    if (!player.seen) continue;

    const Vec2 to = player.position - from;
    if (to.length() > length + 1.0) continue;
    const double angle = std::fabs(math::atan2(cross(lane, to), dot(lane, to)));
    gap = std::min(gap, angle);
  }
  return gap;
}

Shot best_shot(const Scene& scene, Seat self) {
  const double post = scene.server->goal_width / 2.0 - 0.7;
  Shot best{{soccer::kHalfLength, 0.0}, -1.0};
  constexpr int kTargets = 9;

  for (int i = 0; i < kTargets; ++i) {
    const Vec2 target = {soccer::kHalfLength + 0.5, post * (2.0 * i / (kTargets - 1) - 1.0)};
    // Among equally free targets the nearest is best: a small share of the angle per meter.
    const double gap = lane_gap(scene, scene.ball, target);
    const double far = distance(scene.player(self).position, target) * 0.002;
    if (gap - far > best.gap) best = {target, gap - far};
  }
  return best;
}

PlayerCommand shoot(const Scene& scene, Seat self) {
  return kick_to(scene, self, best_shot(scene, self).target, scene.server->ball_speed_max);
}

PlayerCommand pass_to(const Scene& scene, Seat self, Vec2 point) {
  // A ball of speed v rolls v / (1 - decay) meters; at the target it still moves fast enough that
  // few opponents come in between.
  constexpr double kArrival = 1.5;
  const double length = distance(scene.ball, point);
  const double speed =
      std::min(kArrival + length * (1.0 - scene.server->ball_decay), scene.server->ball_speed_max);
  return kick_to(scene, self, point, speed);
}

double tackle_chance(const Scene& scene, Seat self) {
  const ScenePlayer& me = scene.player(self);
  const soccer::ServerParams& server = *scene.server;
  if (me.frozen || !scene.ball_seen) return 0.0;

  // Most players are far away, which needs no rotation.
  const Vec2 to_ball = scene.ball - me.position;
  const double longest =
      std::max(server.tackle_dist, server.tackle_back_dist) + server.tackle_width;
  if (to_ball.squared_length() > longest * longest) return 0.0;

  const Vec2 ball = soccer::rotated_radians(to_ball, -me.body);
  const double reach = ball.x > 0.0 ? server.tackle_dist : server.tackle_back_dist;
  if (reach <= 0.0) return 0.0;
  const double failure = math::pow(std::fabs(ball.x) / reach, server.tackle_exponent) +
                         math::pow(std::fabs(ball.y) / server.tackle_width, server.tackle_exponent);
  return std::clamp(1.0 - failure, 0.0, 1.0);
}

bool can_catch(const Scene& scene, Seat self) {
  const ScenePlayer& me = scene.player(self);
  const bool in_area = me.position.x < -soccer::kHalfLength + soccer::kPenaltyAreaLength &&
                       std::fabs(me.position.y) < soccer::kPenaltyAreaWidth / 2.0;
  return me.goalie && in_area && !me.frozen && scene.ball_seen &&
         distance(me.position, scene.ball) <= scene.server->catchable_area_l;
}

PlayerCommand catch_ball(const Scene& scene, Seat self) {
  const ScenePlayer& me = scene.player(self);
  return soccer::Catch{bearing_degrees(me, scene.ball - me.position)};
}

}  // namespace cls::training
