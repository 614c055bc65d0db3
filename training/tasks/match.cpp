// Match: eleven against eleven with the full referee of the soccer server.
#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

constexpr std::size_t kStopPlay = 1;

void place(const Placing& start) {
  for (const int slot : start.cast.left) start.put(slot, kick_off_position(slot), 0.0);
  for (const int slot : start.cast.right) start.put(slot, kick_off_position(slot), kPi);
  start.put_ball({});
}

Status judge(const simulator::World& world, const OptionValues& options, TaskMemory& memory) {
  const std::array<int, 2> score = {world.team(Side::kLeft).score, world.team(Side::kRight).score};
  const bool left_scored = score[0] > memory.score[0];
  const bool right_scored = score[1] > memory.score[1];
  memory.score = score;
  count_possession(world, memory);

  if (world.mode == soccer::PlayMode::kTimeOver) return Status::kFullTime;
  if (options[kStopPlay] >= 1.0) {
    if (left_scored) return Status::kGoal;
    if (right_scored) return Status::kGoalConceded;
    const bool began = memory.cycles > 1;
    if (options[kStopPlay] >= 2.0 && began && world.clock.time > 1 &&
        world.mode != soccer::PlayMode::kPlayOn &&
        soccer::mode_class(world.mode) != soccer::ModeClass::kWaiting) {
      return Status::kStopped;
    }
  }
  return Status::kInGame;
}

}  // namespace

Task match() {
  return {.id = "Match",
          .summary = "a match with the full referee, 6000 cycles",
          .offense = {1, 11, 11},
          .defense = {0, 11, 11},
          .referee = true,
          .right_goalie = true,
          .max_cycles = 8000,
          .options = {{"difficulty", 1, 0, 1, "no effect: the start is a kick-off"},
                      {"stop_play", 0, 0, 2,
                       "0: until full time; 1: until a goal; 2: until play stops"}},
          .place = place,
          .judge = judge};
}

}  // namespace cls::training
