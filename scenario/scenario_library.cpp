// Finds and reads scenarios and their golden values.
#include "scenario/scenario_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/json_document.h"
#include "base/text/json_text.h"

namespace cls::scenario {
namespace {

namespace fs = std::filesystem;
using base::Json;
using base::JsonDocument;
using base::Result;

constexpr std::string_view kShippedFolder = "examples/scenarios/";

Json golden_of(const Json& all, const std::string& scenario) {
  return all.is_object() && all.contains(scenario) ? all.at(scenario) : Json::object();
}

Result<Json> read_golden(const fs::path& folder) {
  const fs::path file = folder / kGoldenFile;
  std::error_code code;
  if (!fs::exists(file, code)) return Json::object();
  TRY_INIT(const auto text, JsonDocument::read(file));
  return text.root();
}

Result<Scenario> read_one(const fs::path& file, const ResolveSide& resolve) {
  TRY_INIT(const auto golden, read_golden(file.parent_path()));
  TRY_INIT(const auto text, JsonDocument::read(file));
  return parse_scenario(text, golden_of(golden, file.stem().string()), resolve);
}

// Values found by the golden checks, by golden file.
std::map<fs::path, std::map<std::string, Json>> found_values(const SuiteVerdict& suite) {
  std::map<fs::path, std::map<std::string, Json>> files;
  for (const ScenarioVerdict& verdict : suite.scenarios) {
    const Scenario& scenario = *verdict.scenario;
    std::size_t next = 0;
    Json values = Json::object();
    for (const Check& check : scenario.checks) {
      const auto* golden = std::get_if<GoldenCheck>(&check.what);
      if (golden == nullptr || next >= verdict.fingerprints.size()) continue;
      values[golden->what] = verdict.fingerprints[next++];
    }
    const bool has_file = scenario.argument == scenario.file;
    if (values.empty() || !has_file) continue;
    files[fs::path(scenario.file).parent_path() / kGoldenFile][scenario.name] = values;
  }

  return files;
}

}  // namespace

Result<std::vector<Scenario>> shipped_scenarios() {
  Json golden = Json::object();
  for (const ShippedFile& file : shipped_files()) {
    if (file.name == kGoldenFile) golden = Json::parse(file.text);
  }

  std::vector<Scenario> scenarios;
  for (const ShippedFile& file : shipped_files()) {
    if (file.name == kGoldenFile) continue;
    TRY_INIT(const auto text,
             JsonDocument::parse(std::string(kShippedFolder) + std::string(file.name),
                                 std::string(file.text)));
    const std::string name = fs::path(file.name).stem().string();
    TRY_INIT(auto scenario, parse_scenario(text, golden_of(golden, name)));
    scenario.argument = name;
    // In a checkout of cls the path leads to the file.
    std::error_code code;
    scenario.built_in = !fs::exists(scenario.file, code);
    scenarios.push_back(std::move(scenario));
  }

  return scenarios;
}

Result<std::vector<Scenario>> read_scenarios(const fs::path& path, const ResolveSide& resolve) {
  std::vector<fs::path> files = {path};
  std::error_code code;
  if (fs::is_directory(path, code)) {
    files.clear();
    for (const auto& entry : fs::directory_iterator(path, code)) {
      const fs::path& file = entry.path();
      if (file.extension() == ".json" && file.filename() != kGoldenFile) files.push_back(file);
    }
    std::ranges::sort(files);
    if (files.empty()) return base::Error{fmt::format("{}: no scenarios (*.json)", path.string())};
  }

  std::vector<Scenario> scenarios;
  for (const fs::path& file : files) {
    TRY_INIT(auto scenario, read_one(file, resolve));
    scenarios.push_back(std::move(scenario));
  }

  return scenarios;
}

Result<int> accept_golden_values(const SuiteVerdict& suite) {
  int changed = 0;
  for (const auto& [file, scenarios] : found_values(suite)) {
    TRY_INIT(auto golden, read_golden(file.parent_path()));
    for (const auto& [name, values] : scenarios) {
      for (const auto& [what, value] : values.items()) {
        if (golden_of(golden, name).value(what, "") != value) ++changed;
      }
      golden[name] = values;
    }
    std::map<std::string, Json> sorted;
    for (const auto& [name, values] : golden.items()) sorted[name] = values;
    TRY(base::write_file(file, base::json_document(Json(sorted))));
  }

  return changed;
}

}  // namespace cls::scenario
