// Compares tournaments that were played in different ways.
#pragma once

#include <nlohmann/json.hpp>

namespace cls::tests {

/// Matches and standings of a report (`--format json`), without members that depend on how, when
/// and where the matches were played.
nlohmann::json outcome_of(const nlohmann::json& report);

}  // namespace cls::tests
