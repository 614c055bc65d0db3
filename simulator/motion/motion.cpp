// Motion of ball and players in one cycle.
#include "simulator/motion/motion.h"

#include "simulator/motion/goal_post.h"
#include "simulator/referee/collision.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

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
