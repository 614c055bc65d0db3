// The list of tasks, and what they share.
#include "training/tasks/task.h"

#include <algorithm>
#include <utility>

#include "base/index.h"
#include "simulator/referee/areas.h"
#include "soccer/pitch.h"

namespace cls::training {

const std::array<StatusInfo, 9>& statuses() {
  static const std::array<StatusInfo, 9> all = {
      {{"IN_GAME", false, "the episode continues"},
       {"GOAL", false, "the left team scored"},
       {"CAPTURED_BY_DEFENSE", false, "the right team has the ball"},
       {"OUT_OF_BOUNDS", false, "the ball left the area of the task"},
       {"OUT_OF_TIME", true, "too long, or the ball was untouched too long"},
       {"GOAL_CONCEDED", false, "the right team scored"},
       {"REACHED", false, "the aim of the task was reached"},
       {"FULL_TIME", false, "the match is over"},
       {"STOPPED", false, "the referee stopped play"}}};
  return all;
}

void Placing::put(int slot, Vec2 position, double body) const {
  simulator::Player& player = world.player(slot);
  player.position = position;
  player.velocity = {};
  player.acceleration = {};
  player.body = player.pending_body = body;
}

void Placing::put_ball(Vec2 position, Vec2 velocity) const {
  world.ball.position = position;
  world.ball.velocity = velocity;
  world.ball.acceleration = {};
}

Stage Task::stage(Side side) const {
  if (!half) return {-soccer::kHalfLength, soccer::kHalfLength};
  if (side == Side::kRight) return {-soccer::kHalfLength, 0.0};
  return {0.0, soccer::kHalfLength};
}

OptionValues Task::usual_options() const {
  OptionValues values = {};
  for (std::size_t i = 0; i < options.size(); ++i) values[i] = options[i].value;
  return values;
}

const std::vector<Task>& tasks() {
  static const std::vector<Task> all = [] {
    std::vector<Task> list = {
        half_field_offense(), half_field_defense(), keepaway(), penalty(), reach_ball(), match()};
    for (Task& task : academy()) list.push_back(std::move(task));
    return list;
  }();
  return all;
}

const Task* find_task(std::string_view id) {
  const auto found = std::ranges::find(tasks(), id, &Task::id);
  return found == tasks().end() ? nullptr : &*found;
}

std::vector<int> team_slots(const Task& task, Side side, int players) {
  // HFO's numbers of attackers; the others count from 1, their goalie.
  static constexpr std::array<int, soccer::kPlayersPerTeam> kAttackers = {11, 7, 8, 9, 10, 6,
                                                                          3,  2, 4, 5, 1};
  const bool hfo_order = task.half && side == Side::kLeft;
  std::vector<int> slots;
  for (int i = 0; i < players; ++i) {
    slots.push_back(soccer::slot_of(side, hfo_order ? kAttackers[base::index(i)] : i + 1));
  }
  return slots;
}

Vec2 kick_off_position(int slot) {
  // A 4-3-3 by uniform number. The last one stands at the circle, ready for the kick-off.
  static constexpr std::array<Vec2, soccer::kPlayersPerTeam> kPlaces = {{{-50, 0},
                                                                         {-35, -7},
                                                                         {-35, 7},
                                                                         {-33, -20},
                                                                         {-33, 20},
                                                                         {-20, 0},
                                                                         {-18, -11},
                                                                         {-18, 11},
                                                                         {-9.6, -20},
                                                                         {-9.6, 20},
                                                                         {-9.6, 0}}};
  return kPlaces[base::index(soccer::unum_of_slot(slot) - 1)] *
         soccer::sign(soccer::side_of_slot(slot));
}

bool scored_against(const simulator::World& world, Side defender, const TaskMemory& memory) {
  return simulator::crossed_goal_line(world, defender, memory.previous_ball);
}

void count_possession(const simulator::World& world, TaskMemory& memory) {
  ++memory.untouched;
  bool left_has_it = false;

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const simulator::Player& player = world.player(slot);
    if (!player.enabled) continue;
    const double reach = world.type_of(player).kickable_area(world.params().ball_size);
    if (squared_distance(player.position, world.ball.position) >= reach * reach) continue;

    memory.holder = slot;
    memory.untouched = 0;
    left_has_it = player.side == Side::kLeft;
    if (left_has_it) continue;
    ++memory.taken;
    break;
  }

  if (left_has_it) memory.taken = 0;
}

double by_difficulty(double difficulty, double easy, double usual) {
  return easy + (usual - easy) * difficulty;
}

}  // namespace cls::training
