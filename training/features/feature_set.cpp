// The list of feature sets.
#include "training/features/feature_set.h"

namespace cls::training {

const std::vector<const FeatureSet*>& feature_sets() {
  static const std::vector<const FeatureSet*> sets = {&kEgoFeatures, &kHfoLowFeatures,
                                                      &kHfoHighFeatures};
  return sets;
}

const FeatureSet* find_feature_set(std::string_view name) {
  for (const FeatureSet* set : feature_sets()) {
    if (set->name == name) return set;
  }
  return nullptr;
}

}  // namespace cls::training
