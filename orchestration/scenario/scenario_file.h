// Parses scenario files; docs/testing.md describes the format.
#pragma once

#include <string>

#include "base/result.h"
#include "base/text/json_document.h"
#include "orchestration/scenario/scenario.h"

namespace cls::orchestration::scenario {

/// `golden`: golden values of this scenario, an object by key, or null. Reads scripts of mocks
/// relative to the folder of the scenario. Errors name file, line and JSON path.
base::Result<Scenario> parse_scenario(const base::JsonDocument& text, const base::Json& golden);

}  // namespace cls::orchestration::scenario
