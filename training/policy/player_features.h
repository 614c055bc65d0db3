// What a player of a match observes, as the numbers that policies were trained with.
#pragma once

#include <cstddef>
#include <vector>

#include "player/options/options.h"
#include "training/features/feature_set.h"
#include "training/scene/cast.h"

namespace cls::training {

/// Features of eleven against eleven. Reused from one decision to the next.
class PlayerFeatures {
 public:
  explicit PlayerFeatures(const FeatureSet& set);

  /// Of a completed world model and what its player may choose. Valid until the next call. Does not
  /// allocate.
  const std::vector<float>& of(const player::WorldModel& world, const player::OptionTable& table);
  std::size_t count() const { return numbers_.size(); }

 private:
  const FeatureSet* set_;
  Cast everybody_ = everybody();
  Scene scene_;
  std::vector<float> numbers_;
};

}  // namespace cls::training
