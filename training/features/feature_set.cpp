// The list of feature sets.
#include "training/features/feature_set.h"

#include <fmt/format.h>

#include <algorithm>

namespace cls::training {

const std::vector<const FeatureSet*>& feature_sets() {
  static const std::vector<const FeatureSet*> sets = {
      &kEgoFeatures, &kHfoLowFeatures, &kHfoHighFeatures, &kEgo2Features, &kTeamFeatures};
  return sets;
}

const FeatureSet* find_feature_set(std::string_view name) {
  const auto found = std::ranges::find_if(feature_sets(), [name](const FeatureSet* set) {
    return name == set->name || name == fmt::format("{}/{}", set->name, set->version);
  });
  return found == feature_sets().end() ? nullptr : *found;
}

}  // namespace cls::training
