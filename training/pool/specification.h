// The catalog of everything that can be trained, and the description of a pool, as JSON documents.
#pragma once

#include <string_view>

#include "base/text/json.h"
#include "training/pool/pool.h"

namespace cls::training {

constexpr std::string_view kCatalogSchema = "cls.training.catalog/1";

/// kCatalogSchema: tasks, feature sets, action sets, reward terms, statuses.
base::Json catalog();

// Items of the catalog; a feature set with its columns for so many teammates and opponents.
base::Json document_of(const Task& task);
base::Json document_of(const FeatureSet& set, int teammates, int opponents);
base::Json document_of(const ActionSet& set);

/// "cls.training.spec/1": shapes, names, units and bounds of a pool's arrays.
base::Json specification(const Pool& pool);

}  // namespace cls::training
