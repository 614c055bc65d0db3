// Tries the possible noise of two pushes.
#include "simulator/replay/stronger_push.h"

#include <algorithm>

namespace cls::simulator {
namespace {

namespace math = soccer::math;

// Grid of tried noise; values between grid points count as reached.
constexpr int kLengths = 10;
constexpr int kDirections = 32;
constexpr double kGridMargin = 0.06;  // relative to the radius of the disc
constexpr double kRounding = 5e-4;    // of a recorded displacement

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

/// Which of two pushes may have been the stronger, given their recorded sum.
struct Contest {
  bool first = false;
  bool second = false;
};

Contest contest(const World& world, const BallPush& one, const BallPush& other, Vec2 displacement) {
  const soccer::ServerParams& server = world.params();
  const double margin = kGridMargin * (one.noise_max + other.noise_max) + kRounding;
  const std::vector<Vec2> others = pushes_with_noise(other);
  Contest may_win;
  for (const Vec2 push : pushes_with_noise(one)) {
    for (const Vec2 other_push : others) {
      const Vec2 velocity =
          limited(world.ball.velocity + limited(push + other_push, server.ball_accel_max),
                  server.ball_speed_max);
      const double reach = server.ball_rand * velocity.length() + margin;
      if (squared_distance(displacement, velocity) > reach * reach) continue;
      (push.squared_length() > other_push.squared_length() ? may_win.first : may_win.second) = true;
    }
  }
  return may_win;
}

}  // namespace

std::vector<Slot> strongest_pushers(const World& world, const std::vector<BallPush>& pushes,
                                    std::optional<Vec2> displacement) {
  double guaranteed = 0.0;
  for (const BallPush& push : pushes) {
    guaranteed = std::max(guaranteed, push.acceleration.length() - push.noise_max);
  }
  std::vector<Slot> strongest;
  for (const BallPush& push : pushes) {
    if (push.acceleration.length() + push.noise_max >= guaranteed) strongest.push_back(push.slot);
  }
  if (strongest.size() != 2 || pushes.size() != 2 || !displacement) return strongest;
  const Contest may_win = contest(world, pushes[0], pushes[1], *displacement);
  if (may_win.first && !may_win.second) strongest.pop_back();
  if (may_win.second && !may_win.first) strongest.erase(strongest.begin());
  return strongest;
}

}  // namespace cls::simulator
