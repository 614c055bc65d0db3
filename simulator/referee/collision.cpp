// Separates overlapping objects.
#include "simulator/referee/collision.h"

#include <array>

#include "simulator/referee/referee.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr int kMaxRounds = 10;
constexpr int kBallIndex = soccer::kPlayersOnPitch;
constexpr double kVelocityFactor = -0.1;

/// New position of an object in one round: the mean over its contacts.
struct Pushes {
  Vec2 sum;
  int count = 0;
};

struct Resolution {
  std::array<Pushes, soccer::kPlayersOnPitch + 1> pushes;
  std::array<bool, soccer::kPlayersOnPitch + 1> collided = {};

  void push(int index, Vec2 to) {
    Pushes& own = pushes[static_cast<std::size_t>(index)];
    own.sum += to;
    ++own.count;
    collided[static_cast<std::size_t>(index)] = true;
  }
};

struct Separated {
  Vec2 first;
  Vec2 second;
};

bool overlap(Vec2 a, Vec2 b, double radii) { return squared_distance(a, b) < radii * radii; }

// Both objects move the same distance, whatever their masses.
Separated separated(Vec2 a, Vec2 b, double radii, RandomStream& stream) {
  const Vec2 middle = (a + b) / 2.0;
  const double half = radii / 2.0 + math::kEps;
  Vec2 to_a = a - middle;
  Vec2 to_b = b - middle;
  if (a == b || (to_a.length() < math::kEps && to_b.length() < math::kEps)) {
    const double direction = stream.uniform(-math::kPi, math::kPi);
    to_a = soccer::polar_radians(half, direction);
    to_b = soccer::polar_radians(half, math::normalize_radians(direction + math::kPi));
  } else {
    to_a = soccer::with_length(to_a, half);
    to_b = soccer::with_length(to_b, half);
  }

  for (int i = 0; i < 10 && distance(to_a, to_b) < radii; ++i) {
    to_a *= 1.0001;
    to_b *= 1.0001;
  }

  return {middle + to_a, middle + to_b};
}

// Outside play_on the ball stays in place and only the player moves.
void push_off_ball(World& world, Slot slot, double radii, Resolution& resolution) {
  const Vec2 ball = world.ball.position;
  const Vec2 player = world.player(slot).position;

  if (world.mode == PlayMode::kPlayOn) {
    const Separated apart = separated(ball, player, radii, world.random.collision);
    resolution.push(kBallIndex, apart.first);
    resolution.push(slot, apart.second);
    return;
  }

  const double length = radii + math::kEps;
  const Vec2 away =
      player == ball
          ? soccer::polar_radians(length, world.random.collision.uniform(-math::kPi, math::kPi))
          : soccer::with_length(player - ball, length);

  resolution.push(kBallIndex, ball);
  resolution.push(slot, ball + away);
}

bool collide_with_ball(World& world, Resolution& resolution, Events& events) {
  bool found = false;
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    Player& player = world.player(slot);
    if (!player.enabled || slot == world.ball_catcher) continue;
    const double radii = world.params().ball_size + world.type_of(player).player_size;
    if (!overlap(world.ball.position, player.position, radii)) continue;

    found = true;
    player.state |= state::kBallToPlayer | state::kBallCollide;
    player.contacts.ball = true;
    on_ball_touched(world, slot, events);
    push_off_ball(world, slot, radii, resolution);
  }

  return found;
}

/// The fields of a player that are needed here, packed for the loop over all pairs.
struct Body {
  Vec2 position;
  double size;
  Slot slot;
};

void collide(World& world, const Body& first, const Body& second, Resolution& resolution) {
  for (const Slot slot : {first.slot, second.slot}) {
    world.player(slot).state |= state::kPlayerCollide;
    world.player(slot).contacts.player = true;
  }

  const Separated apart =
      separated(first.position, second.position, first.size + second.size, world.random.collision);
  resolution.push(first.slot, apart.first);
  resolution.push(second.slot, apart.second);
}

bool collide_players(World& world, Resolution& resolution) {
  std::array<Body, soccer::kPlayersOnPitch> bodies;
  std::size_t count = 0;
  for (const Player& player : world.players) {
    if (!player.enabled) continue;
    bodies[count++] = {player.position, world.type_of(player).player_size, player.slot()};
  }

  bool found = false;
  for (std::size_t i = 0; i < count; ++i) {
    const Body& first = bodies[i];
    for (std::size_t j = i + 1; j < count; ++j) {
      const Body& second = bodies[j];
      if (!overlap(first.position, second.position, first.size + second.size)) continue;
      found = true;
      collide(world, first, second, resolution);
    }
  }
  return found;
}

void settle(Pushes& pushes, Vec2& position) {
  if (pushes.count > 0) position = pushes.sum / pushes.count;
  pushes = {};
}

}  // namespace

void resolve_collisions(World& world, Events& events) {
  Resolution resolution;
  for (int round = 0; round < kMaxRounds; ++round) {
    const bool with_ball = collide_with_ball(world, resolution, events);
    const bool among_players = collide_players(world, resolution);
    if (!with_ball && !among_players) break;

    settle(resolution.pushes[kBallIndex], world.ball.position);
    for (std::size_t i = 0; i < world.players.size(); ++i) {
      settle(resolution.pushes[i], world.players[i].position);
    }
  }

  if (resolution.collided[kBallIndex]) world.ball.velocity *= kVelocityFactor;
  for (std::size_t i = 0; i < world.players.size(); ++i) {
    if (resolution.collided[i]) world.players[i].velocity *= kVelocityFactor;
  }
}

}  // namespace cls::simulator
