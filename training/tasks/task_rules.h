// Rules that tasks share, and the tasks themselves.
#pragma once

#include "training/tasks/task.h"

namespace cls::training {

/// True if the ball crossed the goal line of `defender` between the posts in this cycle.
bool scored_against(const simulator::World& world, Side defender, const TaskMemory& memory);

/// Counts cycles, possession and untouched cycles as HFO's referee does.
void count_possession(const simulator::World& world, TaskMemory& memory);

/// Linear from `easy` (difficulty 0) to `usual` (difficulty 1).
double by_difficulty(double difficulty, double easy, double usual);

// One file each.
Task half_field_offense();
Task half_field_defense();
Task keepaway();
Task penalty();
Task reach_ball();
Task match();
std::vector<Task> academy();

}  // namespace cls::training
