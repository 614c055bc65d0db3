// The list of feature sets.
#include "training/features/feature_set.h"

#include <algorithm>

namespace cls::training {

const std::vector<const FeatureSet*>& feature_sets() {
  static const std::vector<const FeatureSet*> sets = {&kEgoFeatures, &kHfoLowFeatures,
                                                      &kHfoHighFeatures};
  return sets;
}

const FeatureSet* find_feature_set(std::string_view name) {
  const auto found = std::ranges::find(feature_sets(), name, &FeatureSet::name);
  return found == feature_sets().end() ? nullptr : *found;
}

}  // namespace cls::training
