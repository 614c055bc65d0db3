// What can be trained, and what a pool is, as JSON documents.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "training/pool/pool.h"

namespace cls::training {

constexpr std::string_view kCatalogSchema = "cls.training.catalog/1";

/// kCatalogSchema: tasks, feature sets, action sets, reward terms, statuses.
nlohmann::ordered_json catalog();

// Items of the catalog; a feature set with its columns for so many teammates and opponents.
nlohmann::ordered_json document_of(const Task& task);
nlohmann::ordered_json document_of(const FeatureSet& set, int teammates, int opponents);
nlohmann::ordered_json document_of(const ActionSet& set);

/// "cls.training.spec/1": shapes, names, units and bounds of a pool's arrays.
nlohmann::ordered_json specification(const Pool& pool);

}  // namespace cls::training
