// Comparing tournaments that were played in different ways.
#pragma once

#include <nlohmann/json.hpp>

namespace cls::tests {

/// Of a report (`--format json`): the matches as they ended and the standings, without what depends
/// on who played them, when and where.
nlohmann::json outcome_of(const nlohmann::json& report);

}  // namespace cls::tests
