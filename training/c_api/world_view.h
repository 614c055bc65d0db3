// The physical state of worlds as the struct of the C interface.
#pragma once

#include "base/result.h"
#include "training/c_api/cls_training.h"
#include "training/episode/episode.h"

namespace cls::training {

/// Fills all members but struct_size.
void fill_view(const Episode& episode, cls_training_world& out);

/// Where an episode starts from `world`. The error names the member: "players[3].x: nan is not
/// between -200 and 200".
base::Result<Start> read_start(const cls_training_world& world, const Setup& setup);

}  // namespace cls::training
