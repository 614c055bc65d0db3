// Reading scenarios; docs/testing.md describes the format.
#pragma once

#include <string>

#include "mock-server/json_text.h"
#include "orchestration/scenario/scenario.h"
#include "soccer/result.h"

namespace cls::orchestration {

/// `golden` are the blessed values of this scenario, an object by key, or null. Errors name file,
/// line and place. Script files of mocks are read, relative to the scenario's folder.
soccer::Result<Scenario> parse_scenario(const mock_server::JsonText& text,
                                        const mock_server::Json& golden);

}  // namespace cls::orchestration
