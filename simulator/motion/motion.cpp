// Motion of a cycle.
#include "simulator/motion/motion.h"

#include "simulator/motion/goal_post.h"
#include "simulator/referee/collision.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

/// What motion needs to know of a kind of object (the table of section 3).
struct Kind {
  double radius;
  double decay;
  double rand;
  double weight;
  double speed_max;
  double acceleration_max;
  double push_noise_max = 0.0;  ///< what kicks can add; for forced arrivals only

  // A ball that noise made faster has more noise of motion.
  double push_reach() const { return push_noise_max * (1.0 + rand); }
};

Kind ball_kind(const soccer::ServerParams& server) {
  return {server.ball_size,   server.ball_decay,     server.ball_rand,
          server.ball_weight, server.ball_speed_max, server.ball_accel_max};
}

Kind player_kind(const World& world, const Player& player) {
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

void accelerate(Vec2& velocity, Vec2 acceleration, const Kind& kind) {
  if (acceleration.is_zero()) return;
  limit(acceleration, kind.acceleration_max);
  velocity += acceleration;
  limit(velocity, kind.speed_max);
}

// Uniform in radius and angle, so it is densest in the middle of its disc.
Vec2 motion_noise(double radius_max, RandomStream& stream) {
  const double radius = stream.uniform(0.0, radius_max);
  const double angle = stream.uniform(-math::kPi, math::kPi);
  if (radius == 0.0) return {};
  return soccer::polar_radians(radius, angle);
}

// What took the object from where it would be without noise to where it was seen; zero if that is
// more than noise (and the rounding of the record) can do.
Vec2 explained_noise(Vec2 expected, double radius_max, ShownMotion& shown) {
  constexpr double kRounding = 3e-4;
  shown.expected = expected;
  shown.reach = radius_max;
  const Vec2 noise = *shown.arrival - expected;
  shown.explained = radius_max > 0.0 && noise.length() <= radius_max + kRounding;
  shown.noise = shown.explained ? noise : Vec2{};
  return shown.noise;
}

// Each coordinate of the vector gets its own draw.
double strongest_wind(const Wind& wind, double speed, double weight) {
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

/// One object's increment; true if it hit a goal post.
template <typename Object>
bool increment(const World& world, Object& object, const Kind& kind, RandomStream& stream,
               ShownMotion* shown) {
  accelerate(object.velocity, object.acceleration, kind);
  const double speed = object.velocity.length();
  const double noise_max = kind.rand * speed;
  const Vec2 noise = motion_noise(noise_max, stream);
  if (shown != nullptr && shown->arrival) {
    shown->noise_max = noise_max;
    const double wind_max = strongest_wind(world.wind, speed, kind.weight);
    object.velocity += explained_noise(object.position + object.velocity,
                                       noise_max + kind.push_reach() + wind_max, *shown);
  } else {
    object.velocity += noise;
    object.velocity += wind_push(world.wind, object.velocity.length(), kind.weight, stream);
  }
  const bool hit = advance_past_posts(object.position, object.velocity, kind.radius,
                                      world.params().goal_width, stream);
  object.velocity *= kind.decay;
  object.acceleration = {};
  return hit;
}

void commit_angles(Player& player) {
  player.body = player.pending_body;
  player.neck = player.pending_neck;
}

void carry_ball(World& world) {
  if (world.ball_catcher == kNobody) return;
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
  Kind ball = ball_kind(world.params());
  ForcedOutcomes* forced = world.forced ? &*world.forced : nullptr;
  if (forced != nullptr) ball.push_noise_max = forced->push_noise_max;
  increment(world, world.ball, ball, world.random.ball_motion,
            forced != nullptr ? &forced->ball : nullptr);
  for (std::size_t i = 0; i < world.players.size(); ++i) {
    Player& player = world.players[i];
    if (!player.enabled) continue;
    commit_angles(player);
    if (increment(world, player, player_kind(world, player), world.random.player_motion[i],
                  forced != nullptr ? &forced->players[i] : nullptr)) {
      player.state |= state::kPostCollide;
      player.contacts.post = true;
    }
  }
  resolve_collisions(world, events);
  carry_ball(world);
}

}  // namespace cls::simulator
