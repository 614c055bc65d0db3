// Reading scenarios; docs/testing.md describes the format.
#pragma once

#include <string>

#include "base/result.h"
#include "base/text/json_text.h"
#include "orchestration/scenario/scenario.h"

namespace cls::orchestration::scenario {

/// `golden` are the blessed values of this scenario, an object by key, or null. Errors name file,
/// line and place. Script files of mocks are read, relative to the scenario's folder.
base::Result<Scenario> parse_scenario(const base::JsonText& text, const base::Json& golden);

}  // namespace cls::orchestration::scenario
