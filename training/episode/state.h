// The full state of an episode as numbers, for critics that may see everything.
#pragma once

#include "training/episode/setup.h"

namespace cls::training {

Columns state_columns(const Cast& cast);

/// Writes as many numbers as there are columns, from the left team's view.
void fill_state(const simulator::World& world, const Cast& cast, double time_left, float* out);

}  // namespace cls::training
