// Where scenarios come from: files, folders, and those that are part of the binary.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "orchestration/scenario/scenario.h"
#include "orchestration/scenario/suite.h"

namespace cls::orchestration::scenario {

/// A file of examples/scenarios as it was when `cls` was built.
struct ShippedFile {
  std::string_view name;  ///< "kick_in.json"
  std::string_view text;
};
const std::vector<ShippedFile>& shipped_files();

/// Values that --bless keeps, of all scenarios of a folder.
inline constexpr const char* kGoldenFile = "golden.json";

/// All that are part of the binary, by name.
base::Result<std::vector<Scenario>> shipped_scenarios();

/// A file, or all *.json of a folder in the order of their names. Errors name file and line.
base::Result<std::vector<Scenario>> read_scenarios(const std::filesystem::path& path);

/// Writes what the golden checks of these scenarios found into the golden files beside them;
/// returns how many values are new or other than before. Shipped ones without a file are left out.
base::Result<int> bless(const SuiteVerdict& suite);

}  // namespace cls::orchestration::scenario
