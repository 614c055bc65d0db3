// Separates overlapping objects.
#include "simulator/referee/collision.h"

#include <array>
#include <bit>
#include <cstdint>

#include "simulator/referee/referee.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr int kMaxRounds = 10;
constexpr int kBallIndex = soccer::kPlayersOnPitch;
constexpr double kVelocityFactor = -0.1;

/// Where the contacts of a round push an object; the mean is its new position.
struct Pushes {
  Vec2 sum;
  int count;
};

/// Objects by index: slots of players, and kBallIndex.
using ObjectSet = std::uint32_t;

template <typename Do>
void for_each(ObjectSet objects, Do&& what) {
  for (; objects != 0; objects &= objects - 1) {
    what(static_cast<std::size_t>(std::countr_zero(objects)));
  }
}

struct Resolution {
  std::array<Pushes, soccer::kPlayersOnPitch + 1> pushes;  ///< of those in `pushed`
  ObjectSet pushed = 0;                                    ///< in this round
  ObjectSet collided = 0;                                  ///< in any round

  void push(int index, Vec2 to) {
    const ObjectSet own = ObjectSet{1} << index;
    Pushes& pushes_of_own = pushes[static_cast<std::size_t>(index)];
    if ((pushed & own) == 0) pushes_of_own = {{}, 0};
    pushes_of_own.sum += to;
    ++pushes_of_own.count;
    pushed |= own;
    collided |= own;
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

void collide(World& world, const Bodies& bodies, std::size_t first, std::size_t second,
             Resolution& resolution) {
  for (const std::size_t i : {first, second}) {
    Player& player = world.player(bodies.slots[i]);
    player.state |= state::kPlayerCollide;
    player.contacts.player = true;
  }

  const Separated apart =
      separated(bodies.position(first), bodies.position(second),
                bodies.size[first] + bodies.size[second], world.random.collision);
  resolution.push(bodies.slots[first], apart.first);
  resolution.push(bodies.slots[second], apart.second);
}

bool collide_players(World& world, Bodies& bodies, Resolution& resolution) {
  const Overlaps overlaps = find_overlaps(bodies);
  if (bodies.suspects == 0) return false;
  for (std::size_t first = 0; first < bodies.count; ++first) {
    for_each(overlaps[first],
             [&](std::size_t second) { collide(world, bodies, first, second, resolution); });
  }
  return true;
}

Vec2& position_of(World& world, std::size_t object) {
  return object == kBallIndex ? world.ball.position : world.players[object].position;
}
Vec2& velocity_of(World& world, std::size_t object) {
  return object == kBallIndex ? world.ball.velocity : world.players[object].velocity;
}

void settle(World& world, Bodies& bodies, Resolution& resolution) {
  for_each(resolution.pushed, [&](std::size_t object) {
    const Pushes& pushes = resolution.pushes[object];
    const Vec2 position = pushes.sum / pushes.count;
    position_of(world, object) = position;
    if (object != kBallIndex) move_body(bodies, static_cast<Slot>(object), position);
  });
  resolution.pushed = 0;
}

}  // namespace

void resolve_collisions(World& world, Bodies& bodies, Events& events) {
  Resolution resolution;
  refresh(bodies, world);
  for (int round = 0; round < kMaxRounds; ++round) {
    const bool with_ball =
        overlapping(bodies, world.ball.position, world.params().ball_size) != 0 &&
        collide_with_ball(world, resolution, events);
    if (with_ball) refresh(bodies, world);  // rules may have moved players
    const bool among_players = collide_players(world, bodies, resolution);
    if (!with_ball && !among_players) break;
    settle(world, bodies, resolution);
  }

  for_each(resolution.collided,
           [&](std::size_t object) { velocity_of(world, object) *= kVelocityFactor; });
}

void resolve_collisions(World& world, Events& events) {
  Bodies bodies;
  resolve_collisions(world, bodies, events);
}

}  // namespace cls::simulator
