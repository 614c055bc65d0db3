// Reach ball: run to the ball anywhere on the pitch until it can be kicked.
#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

constexpr std::size_t kDifficulty = 0;
constexpr std::size_t kSpeed = 1;

void place(const Placing& start) {
  const double d = start.options[kDifficulty];
  const double range = by_difficulty(d, 0.1, 0.95);
  const auto anywhere = [&](double share) {
    const double x = start.random.uniform(-share, share) * soccer::kHalfLength;
    return Vec2{x, start.random.uniform(-share, share) * soccer::kHalfWidth};
  };

  const double heading = start.random.uniform(-kPi, kPi);
  start.put_ball(anywhere(range), soccer::polar_radians(d * start.options[kSpeed], heading));

  for (const int slot : start.cast.left) {
    const Vec2 place = anywhere(range);
    start.put(slot, place, start.random.uniform(-kPi, kPi));
  }
}

Status judge(const simulator::World& world, const OptionValues& /*options*/, TaskMemory& memory) {
  count_possession(world, memory);
  return memory.untouched == 0 ? Status::kReached : Status::kInGame;
}

}  // namespace

Task reach_ball() {
  return {
      .id = "ReachBall",
      .summary = "run to the ball until it can be kicked",
      .offense = {1, 11, 1},
      .actions = "low",
      .max_cycles = 200,
      .options = {{"difficulty", 1, 0, 1, "0: near and at rest; 1: anywhere, rolling at `speed`"},
                  {"speed", 0, 0, 2.7, "meters per cycle of the ball at the start"}},
      .place = place,
      .judge = judge};
}

}  // namespace cls::training
