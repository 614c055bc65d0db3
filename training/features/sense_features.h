// What agents know of their own senses, for those who choose them: after the feature set's columns.
#pragma once

#include "training/scene/column.h"
#include "training/senses/perceiver.h"

namespace cls::training {

/// None without choices.
Columns sense_columns(const SenseOptions& options);

/// Writes as many numbers as there are columns.
void fill_senses(const Perceiver& agent, const SenseOptions& options, float* out);

}  // namespace cls::training
