// Motion of ball and players in one cycle.
#include "simulator/motion/motion.h"

#include <cmath>
#include <optional>

#include "simulator/referee/collision.h"
#include "soccer/pitch.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr int kMaxBounces = 100;

/// Goal posts as obstacles: the object is a point, the post a circle with the sum of both radii.
struct Posts {
  double x;
  double y;
  double reach;  ///< radius of the obstacle

  Vec2 nearest_to(Vec2 p) const { return {p.x > 0.0 ? x : -x, p.y > 0.0 ? y : -y}; }

  bool can_reach(Vec2 p, double travel) const {
    const double margin = reach + travel;
    return std::fabs(std::fabs(p.x) - x) <= margin && std::fabs(std::fabs(p.y) - y) <= margin;
  }
};

Vec2 reflect(Vec2 v, Vec2 axis) {
  const double length2 = axis.squared_length();
  if (length2 == 0.0) return v;
  return v - axis * (2.0 * dot(v, axis) / length2);
}

bool push_out(const Posts& posts, Vec2& position, Vec2& velocity, RandomStream& stream) {
  bool hit = false;
  Vec2 post = posts.nearest_to(position);
  while (distance(position, post) < posts.reach) {
    hit = true;
    Vec2 away = position - post;
    away = away.is_zero()
               ? soccer::polar_radians(posts.reach, stream.uniform(-math::kPi, math::kPi))
               : soccer::with_length(away, posts.reach);
    position = post + away;
    while (distance(position, post) < posts.reach) {
      away *= 1.01;
      position = post + away;
    }

    velocity = reflect(velocity, post - position);
    post = posts.nearest_to(position);
  }
  return hit;
}

// First intersection of the segment from `from` to `to` with the circle.
std::optional<Vec2> first_intersection(Vec2 from, Vec2 to, Vec2 center, double radius) {
  const Vec2 path = to - from;
  const double length2 = path.squared_length();
  if (length2 == 0.0) return std::nullopt;

  const Vec2 start = from - center;
  if (std::sqrt(length2) < start.length() - radius) return std::nullopt;

  const double area = cross(start, to - center);
  const double discriminant = radius * radius * length2 - area * area;
  if (discriminant <= 0.0) return std::nullopt;

  const double middle = -dot(start, path) / length2;
  const double half = std::sqrt(discriminant) / length2;
  const double first = middle - half;
  const double second = middle + half;
  const auto on_segment = [](double t) { return t >= 0.0 && t <= 1.0; };
  if (on_segment(first)) {
    // Leaving the circle along its tangent is not a contact.
    if (first == 0.0 && !on_segment(second)) return std::nullopt;
    return from + path * first;
  }

  if (on_segment(second) && second != 0.0) return from + path * second;
  return std::nullopt;
}

/// Physical constants of an object (table of docs/spec/simulation-model.md 3).
struct Physics {
  double radius;
  double decay;
  double rand;
  double weight;
  double speed_max;
  double acceleration_max;
  double push_noise_max = 0.0;  ///< maximum kick noise; used during log replay only

  // A ball that kick noise accelerated has more motion noise.
  double push_reach() const { return push_noise_max * (1.0 + rand); }
};

Physics ball_physics(const soccer::ServerParams& server) {
  return {server.ball_size,   server.ball_decay,     server.ball_rand,
          server.ball_weight, server.ball_speed_max, server.ball_accel_max};
}

Physics player_physics(const World& world, const Player& player) {
  const soccer::ServerParams& server = world.params();
  const soccer::PlayerType& type = world.type_of(player);
  const double slowness = slowness_on_top(world, player);

  return {type.player_size,
          type.player_decay,
          player_rand(world, player),
          server.player_weight,
          type.player_speed_max * slowness,
          server.player_accel_max * slowness};
}

void limit(Vec2& v, double length) {
  if (v.squared_length() > length * length) v = soccer::with_length(v, length);
}

void accelerate(Vec2& velocity, Vec2 acceleration, const Physics& physics) {
  if (acceleration.is_zero()) return;
  limit(acceleration, physics.acceleration_max);
  velocity += acceleration;
  limit(velocity, physics.speed_max);
}

// Uniform in radius and angle, so the density is highest at the center of the disc.
Vec2 motion_noise(double radius_max, RandomStream& stream) {
  const double radius = stream.uniform(0.0, radius_max);
  const double angle = stream.uniform(-math::kPi, math::kPi);

  if (radius == 0.0) return {};
  return soccer::polar_radians(radius, angle);
}

// Noise that leads from `expected` to the recorded arrival; zero if it exceeds the possible noise
// plus the rounding of the log.
Vec2 explaining_noise(Vec2 expected, double radius_max, RecordedMotion& recorded) {
  constexpr double kRounding = 3e-4;
  recorded.expected = expected;
  recorded.reach = radius_max;

  const Vec2 noise = *recorded.arrival - expected;
  recorded.explained = radius_max > 0.0 && noise.length() <= radius_max + kRounding;
  recorded.noise = recorded.explained ? noise : Vec2{};
  return recorded.noise;
}

// Maximum acceleration by wind; each coordinate has its own draw.
double max_wind(const Wind& wind, double speed, double weight) {
  if (wind.rand < math::kEps) return 0.0;
  return (wind.vector.length() + 2.0 * wind.rand) * speed / (weight * 10000.0);
}

Vec2 wind_push(const Wind& wind, double speed, double weight, RandomStream& stream) {
  if (wind.rand < math::kEps) return {};

  const double scale = speed / (weight * 10000.0);
  const double x = wind.vector.x + stream.uniform(-wind.rand, wind.rand);
  const double y = wind.vector.y + stream.uniform(-wind.rand, wind.rand);
  return Vec2{x, y} * scale;
}

/// Moves one object (rcssserver MPObject::_inc); returns true if it hit a goal post.
template <typename Object>
bool increment(const World& world, Object& object, const Physics& physics, RandomStream& stream,
               RecordedMotion* recorded) {
  accelerate(object.velocity, object.acceleration, physics);
  const double speed = object.velocity.length();
  const double noise_max = physics.rand * speed;
  const Vec2 noise = motion_noise(noise_max, stream);

  if (recorded != nullptr && recorded->arrival) {
    recorded->noise_max = noise_max;
    const double wind_max = max_wind(world.wind, speed, physics.weight);
    object.velocity += explaining_noise(object.position + object.velocity,
                                        noise_max + physics.push_reach() + wind_max, *recorded);
  } else {
    object.velocity += noise;
    object.velocity += wind_push(world.wind, object.velocity.length(), physics.weight, stream);
  }

  const bool hit = advance_past_posts(object.position, object.velocity, physics.radius,
                                      world.params().goal_width, stream);
  object.velocity *= physics.decay;
  object.acceleration = {};
  return hit;
}

void commit_angles(Player& player) {
  player.body = player.pending_body;
  player.neck = player.pending_neck;
}

void carry_ball(World& world) {
  if (world.ball_catcher == kNoPlayer) return;

  const Player& catcher = world.player(world.ball_catcher);
  const double reach = world.type_of(catcher).player_size + world.params().ball_size;
  world.ball.position = catcher.position + soccer::polar_radians(reach, catcher.body);
}

}  // namespace

bool advance_past_posts(Vec2& position, Vec2& velocity, double radius, double goal_width,
                        RandomStream& stream) {
  const Posts posts{soccer::kHalfLength - soccer::kGoalPostRadius,
                    goal_width / 2.0 + soccer::kGoalPostRadius, soccer::kGoalPostRadius + radius};

  const double speed = velocity.length();
  if (!posts.can_reach(position, speed)) {
    position += velocity;
    return false;
  }
  bool hit = push_out(posts, position, velocity, stream);

  Vec2 target = position + velocity;
  for (int bounce = 0; bounce < kMaxBounces && !(position == target); ++bounce) {
    Vec2 post = posts.nearest_to(position);
    std::optional<Vec2> contact = first_intersection(position, target, post, posts.reach);
    if (const Vec2 other = posts.nearest_to(target); !contact && !(other == post)) {
      post = other;
      contact = first_intersection(position, target, post, posts.reach);
    }
    if (!contact) break;

    hit = true;
    const Vec2 rest = reflect(target - *contact, post - *contact);
    // Slightly outside the circle, so that the next iteration does not find the same contact.
    position = *contact + soccer::with_length(*contact - post, math::kEps);
    target = position + rest;
    velocity = soccer::polar_radians(speed, soccer::direction_radians(rest));
  }

  position = target;
  return hit;
}

double player_rand(const World& world, const Player& player) {
  const soccer::ServerParams& server = world.params();
  if (!server.team_actuator_noise) return server.player_rand;

  return server.player_rand *
         (player.side == Side::kLeft ? server.prand_factor_l : server.prand_factor_r);
}

double slowness_on_top(const World& world, const Player& player) {
  if (player.position.y >= 0.0) return 1.0;
  return player.side == Side::kLeft ? world.params().slowness_on_top_for_left_team
                                    : world.params().slowness_on_top_for_right_team;
}

void turn_players(World& world) {
  for (Player& player : world.players) {
    if (!player.joined) continue;
    commit_angles(player);
    player.velocity = {};
    player.acceleration = {};
  }
}

void move_objects(World& world, Events& events) {
  Physics ball = ball_physics(world.params());
  ReplayOverrides* overrides = world.overrides ? &*world.overrides : nullptr;
  if (overrides != nullptr) ball.push_noise_max = overrides->push_noise_max;

  increment(world, world.ball, ball, world.random.ball_motion,
            overrides != nullptr ? &overrides->ball : nullptr);

  for (std::size_t i = 0; i < world.players.size(); ++i) {
    Player& player = world.players[i];
    if (!player.enabled) continue;
    commit_angles(player);
    if (increment(world, player, player_physics(world, player), world.random.player_motion[i],
                  overrides != nullptr ? &overrides->players[i] : nullptr)) {
      player.state |= state::kPostCollide;
      player.contacts.post = true;
    }
  }

  resolve_collisions(world, events);
  carry_ball(world);
}

}  // namespace cls::simulator
