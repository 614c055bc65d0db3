// Trying noises.
#include "simulator/replay/stronger_push.h"

#include <algorithm>

namespace cls::simulator {
namespace {

namespace math = soccer::math;

// Each noise is tried at so many lengths and directions; what lies between counts as reached.
constexpr int kLengths = 10;
constexpr int kDirections = 32;
constexpr double kBetween = 0.06;   // of the disc's radius
constexpr double kRounding = 5e-4;  // of a recorded way

std::vector<Vec2> pushes_with_noise(const BallPush& push) {
  std::vector<Vec2> tried = {push.acceleration};
  if (push.noise_max <= 0.0) return tried;
  for (int length = 1; length <= kLengths; ++length) {
    for (int direction = 0; direction < kDirections; ++direction) {
      tried.push_back(push.acceleration + soccer::polar_degrees(push.noise_max * length / kLengths,
                                                                360.0 / kDirections * direction));
    }
  }
  return tried;
}

Vec2 limited(Vec2 v, double length) {
  return v.squared_length() > length * length ? soccer::with_length(v, length) : v;
}

/// Which of two pushes may have been the stronger, by what they came to together.
struct Contest {
  bool first = false;
  bool second = false;
};

Contest contest(const World& world, const BallPush& one, const BallPush& other, Vec2 way) {
  const soccer::ServerParams& server = world.params();
  const double between = kBetween * (one.noise_max + other.noise_max) + kRounding;
  const std::vector<Vec2> others = pushes_with_noise(other);
  Contest may_win;
  for (const Vec2 push : pushes_with_noise(one)) {
    for (const Vec2 other_push : others) {
      const Vec2 velocity =
          limited(world.ball.velocity + limited(push + other_push, server.ball_accel_max),
                  server.ball_speed_max);
      const double reach = server.ball_rand * velocity.length() + between;
      if (squared_distance(way, velocity) > reach * reach) continue;
      (push.squared_length() > other_push.squared_length() ? may_win.first : may_win.second) = true;
    }
  }
  return may_win;
}

}  // namespace

std::vector<Slot> strongest_pushers(const World& world, const std::vector<BallPush>& pushes,
                                    std::optional<Vec2> way) {
  double sure = 0.0;
  for (const BallPush& push : pushes) {
    sure = std::max(sure, push.acceleration.length() - push.noise_max);
  }
  std::vector<Slot> strongest;
  for (const BallPush& push : pushes) {
    if (push.acceleration.length() + push.noise_max >= sure) strongest.push_back(push.slot);
  }
  if (strongest.size() != 2 || pushes.size() != 2 || !way) return strongest;
  const Contest may_win = contest(world, pushes[0], pushes[1], *way);
  if (may_win.first && !may_win.second) strongest.pop_back();
  if (may_win.second && !may_win.first) strongest.erase(strongest.begin());
  return strongest;
}

}  // namespace cls::simulator
