// Penalty: one shooter against one goalie, as in a shoot-out.
#include <cmath>

#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

constexpr std::size_t kDifficulty = 0;
constexpr std::size_t kDistance = 1;

void place(const Placing& start) {
  const double far = by_difficulty(start.options[kDifficulty], 11.0, start.options[kDistance]);
  const Vec2 ball = {soccer::kHalfLength - far, 0.0};
  start.put_ball(ball);
  // The shooter stands behind the ball, up to a meter away.
  start.put(start.cast.left.front(),
            {ball.x - start.random.uniform(0.5, 1.5), start.random.uniform(-1.0, 1.0)}, 0.0);
  for (const int slot : start.cast.right) start.put(slot, {soccer::kHalfLength, 0.0}, kPi);
}

// The goalie wins when it has the ball, catches it, or it leaves the half.
Status judge(const simulator::World& world, const OptionValues& /*options*/, TaskMemory& memory) {
  if (scored_against(world, Side::kRight, memory)) {
    ++memory.score[0];
    return Status::kGoal;
  }

  const Vec2 ball = world.ball.position;
  if (ball.x > soccer::kHalfLength || ball.x < 0.0 || std::fabs(ball.y) > soccer::kHalfWidth) {
    return Status::kOutOfBounds;
  }

  count_possession(world, memory);
  return memory.taken > 0 ? Status::kCaptured : Status::kInGame;
}

}  // namespace

Task penalty() {
  return {.id = "Penalty",
          .summary = "a shooter against a goalie, as in a shoot-out",
          .offense = {1, 1, 1},
          .defense = {0, 1, 1},
          .actions = "low",
          .right_goalie = true,
          .half = true,
          .max_cycles = 200,
          .options = {{"difficulty", 1, 0, 1, "0: from 11 m; 1: from `distance`"},
                      {"distance", 42.5, 5, 50, "meters from the ball to the goal line"}},
          .place = place,
          .judge = judge};
}

}  // namespace cls::training
