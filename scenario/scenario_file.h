// Parses scenario files; docs/testing.md describes the format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/result.h"
#include "base/text/json_document.h"
#include "scenario/scenario.h"

namespace cls::scenario {

/// What the side of a scenario in `folder` stands for: the endpoint of a team's name, for use in
/// the working directory, or the side unchanged. Empty: sides have no names.
using ResolveSide = std::function<base::Result<std::string>(const std::string& side,
                                                            const std::filesystem::path& folder)>;

/// `golden`: golden values of this scenario, an object by key, or null. Reads scripts of mocks
/// relative to the folder of the scenario. Errors name file, line and JSON path.
base::Result<Scenario> parse_scenario(const base::JsonDocument& text, const base::Json& golden,
                                      const ResolveSide& resolve = {});

}  // namespace cls::scenario
