// Compares tournaments that were played in different ways.
#pragma once

#include "base/text/json.h"

namespace cls::tests {

/// Matches and standings of a report (`--format json`), without members that depend on how, when
/// and where the matches were played.
base::Json outcome_of(const base::Json& report);

}  // namespace cls::tests
