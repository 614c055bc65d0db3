// Sources of scenarios: files, folders and the shipped ones in the binary.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scenario/scenario.h"
#include "scenario/scenario_file.h"
#include "scenario/suite.h"

namespace cls::scenario {

/// A file of examples/scenarios, embedded at build time.
struct ShippedFile {
  std::string_view name;  ///< "kick_in.json"
  std::string_view text;
};
const std::vector<ShippedFile>& shipped_files();

/// File with the golden values of all scenarios in its folder.
inline constexpr const char* kGoldenFile = "golden.json";

/// All shipped scenarios, by name.
base::Result<std::vector<Scenario>> shipped_scenarios();

/// Reads a file, or all *.json of a folder sorted by name. Errors name file and line.
base::Result<std::vector<Scenario>> read_scenarios(const std::filesystem::path& path,
                                                   const ResolveSide& resolve = {});

/// Writes the values found by the golden checks into the golden files beside the scenarios. Returns
/// the number of changed values. Skips shipped scenarios, which have no file.
base::Result<int> accept_golden_values(const SuiteVerdict& suite);

}  // namespace cls::scenario
