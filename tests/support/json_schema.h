// Checks JSON documents against the part of JSON Schema that our fixtures use.
#pragma once

#include <string>
#include <vector>

#include "base/text/json.h"

namespace cls::tests {

/// What contradicts the schema, with its place; empty: nothing. Knows type, required, properties,
/// items, enum, const, pattern, $ref (of definitions), allOf, if and then, and throws
/// std::runtime_error for other keywords, so that no requirement is skipped unseen.
std::vector<std::string> schema_errors(const base::Json& schema, const base::Json& document);

}  // namespace cls::tests
