// Keepaway: the left team keeps the ball in a square of 20 m. Places and ends are those of the
// soccer server's keepaway mode.
#include <cmath>

#include "soccer/math.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

constexpr int kTurnover = 4;  // cycles of possession by the takers
constexpr std::size_t kDifficulty = 0;
constexpr std::size_t kSize = 1;

void place(const Placing& start) {
  const double half = start.options[kSize] / 2.0;
  const double margin = 3.0;
  const int keepers = static_cast<int>(start.cast.left.size());
  int corner = start.random.integer(keepers);

  for (const int slot : start.cast.left) {
    const double dx = start.random.uniform(0.0, margin);
    const double dy = start.random.uniform(0.0, margin);
    Vec2 place = {dx - margin / 2.0, dy - margin / 2.0};
    if (corner == 0) place = {-half + dx, -half + dy};
    if (corner == 1) place = {half - dx, -half + dy};
    if (corner == 2) place = {half - dx, half - dy};
    start.put(slot, place, soccer::direction_radians(-place));
    corner = (corner + 1) % keepers;
  }

  for (const int slot : start.cast.right) {
    const double dx = start.random.uniform(0.0, margin);
    const double dy = start.random.uniform(0.0, margin);
    // Easy: the takers start outside the area.
    const double away = by_difficulty(start.options[kDifficulty], 20.0, 0.0);
    start.put(slot, {-half + dx - away, half - dy + away}, -kPi / 4.0);
  }

  start.put_ball({-half + 4.0, -half + 4.0});
}

Status judge(const simulator::World& world, const OptionValues& options, TaskMemory& memory) {
  const double half = options[kSize] / 2.0;
  const Vec2 ball = world.ball.position;
  if (std::fabs(ball.x) >= half || std::fabs(ball.y) >= half) return Status::kOutOfBounds;
  if (memory.taken >= kTurnover) return Status::kCaptured;
  count_possession(world, memory);
  return Status::kInGame;
}

}  // namespace

Task keepaway() {
  return {.id = "Keepaway",
          .summary = "keepers pass the ball away from takers in a small square",
          .offense = {2, 8, 3},
          .defense = {1, 8, 2},
          .max_cycles = 3000,
          .options = {{"difficulty", 1, 0, 1, "0: the takers start 20 m away; 1: in their corner"},
                      {"size", 20, 10, 60, "length of the square's sides in meters"}},
          .place = place,
          .judge = judge};
}

}  // namespace cls::training
