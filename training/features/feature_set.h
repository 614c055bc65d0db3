// Observations of an agent as arrays of numbers: a named, versioned set of features.
#pragma once

#include <string_view>
#include <vector>

#include "training/scene/cast.h"
#include "training/scene/column.h"

namespace cls::training {

struct FeatureSet {
  std::string_view name;
  int version = 1;
  std::string_view summary;
  bool left_only = false;       ///< meaningless for the right team, and refused for it
  bool needs_openings = false;  ///< reads PointOfView::openings
  bool needs_options = false;   ///< reads PointOfView::world and options
  /// Columns for so many teammates (without the agent) and opponents.
  Columns (*columns)(int teammates, int opponents) = nullptr;
  /// Writes as many numbers as there are columns. Does not allocate.
  void (*fill)(const PointOfView& view, float* out) = nullptr;
};

/// A change of a set's columns or values needs a new version.
extern const FeatureSet kEgoFeatures;
extern const FeatureSet kEgo2Features;
extern const FeatureSet kHfoLowFeatures;
extern const FeatureSet kHfoHighFeatures;
extern const FeatureSet kTeamFeatures;

const std::vector<const FeatureSet*>& feature_sets();

/// By name ("ego": the oldest version) or by name and version ("ego/2"); null for unknown ones.
const FeatureSet* find_feature_set(std::string_view name);

}  // namespace cls::training
