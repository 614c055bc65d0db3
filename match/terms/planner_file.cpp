// Parses planner files with toml++.
#include "match/terms/planner_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <optional>

#include "base/io/whole_file.h"
#include "base/text/stored_formats.h"
#include "match/terms/toml_schema.h"
#include "player/world/planner_parameters.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

Error error_at(const std::string& name, const toml::source_region& place, std::string_view what) {
  return Error{fmt::format("{}:{}: {}", name, place.begin.line, what)};
}

// The table of toml++ is sorted by name; errors are reported in the order of the file.
std::vector<std::pair<std::string_view, const toml::node*>> in_file_order(const toml::table& top) {
  std::vector<std::pair<std::string_view, const toml::node*>> entries;
  for (const auto& [key, node] : top) entries.emplace_back(key.str(), &node);
  std::ranges::sort(entries, {},
                    [](const auto& entry) { return entry.second->source().begin.line; });
  return entries;
}

// toml++ makes no double of integers that it would have to round.
std::optional<double> number_of(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  return node.value<double>();
}

// A file without a schema is of the first version. Of a newer one no parameter is certain.
std::optional<Error> schema_error_of(const toml::table& top, const std::string& name) {
  const toml::node* node = top.get("schema");
  if (node == nullptr) return std::nullopt;
  const auto error = schema_error(*node, base::kPlannerSchema);
  if (!error) return std::nullopt;
  return error_at(name, node->source(), *error);
}

}  // namespace

Result<SharedPlannerParameters> parse_planner_file(std::string_view text, const std::string& name) {
  toml::table top;
  try {
    top = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    return error_at(name, error.source(), error.description());
  }

  auto parameters = std::make_shared<player::PlannerParameters>();
  if (auto error = schema_error_of(top, name)) return *std::move(error);
  for (const auto& [key, node] : in_file_order(top)) {
    if (key == "schema") continue;

    const auto value = number_of(*node);
    if (!value) return error_at(name, node->source(), fmt::format("{}: must be a number", key));
    const auto set = set_planner_parameter(*parameters, key, *value);
    if (!set) return error_at(name, node->source(), set.error().message);
  }
  return SharedPlannerParameters(std::move(parameters));
}

Result<SharedPlannerParameters> read_planner_file(const std::filesystem::path& file) {
  if (const auto why = base::why_no_file(file)) {
    return Error{fmt::format("{}: {}; `cls init --planner` writes one", file.string(), *why)};
  }
  const auto text = base::read_text(file);
  if (!text) return Error{fmt::format("{}: cannot be read", file.string())};
  return parse_planner_file(*text, file.string());
}

std::string commented_planner_file() {
  std::string text =
      "# Parameters of the offensive planner, with their defaults. A side plays with this file as\n"
      "# planner:FILE=SIDE, such as planner:planner.toml=mock:planner (docs/mock.md). A line\n"
      "# may be omitted. After each value: its range, its unit and what it is.\n";
  fmt::format_to(std::back_inserter(text), "\nschema = {}  # version of the format of this file\n",
                 base::kPlannerSchema);
  const player::PlannerParameters defaults;
  std::string_view group;
  for (const player::PlannerParameter& row : player::planner_parameter_table()) {
    if (row.group != group) fmt::format_to(std::back_inserter(text), "\n# {}\n", row.group);
    group = row.group;
    fmt::format_to(std::back_inserter(text), "{} = {:g}  # {:g} to {:g} {}: {}\n", row.name,
                   value_of(defaults, row), row.low, row.high, row.unit, row.effect);
  }
  return text;
}

}  // namespace cls::match
