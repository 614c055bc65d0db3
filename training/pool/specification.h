// What can be trained, and what a pool is, as JSON documents.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "training/pool/pool.h"

namespace cls::training {

/// "cls.training.catalog/1": tasks, feature sets, action sets, reward terms, statuses.
nlohmann::ordered_json catalog();

/// A task of the catalog, with the columns of its default features and actions.
nlohmann::ordered_json task_document(const Task& task);

/// "cls.training.spec/1": shapes, names, units and bounds of a pool's arrays.
nlohmann::ordered_json specification(const Pool& pool);

}  // namespace cls::training
