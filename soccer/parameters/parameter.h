// What the parameter tables have in common: entries, look-up by name, values as text.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/result.h"
#include "base/text/suggestion.h"

namespace cls::soccer {

/// Clients below a version are not sent what came later; monitors and game logs get everything.
constexpr int kAllVersions = 999;

/// One row of a parameter table: the member it describes, since when it is sent to clients, and
/// what it means (for help texts).
template <typename Params>
struct Parameter {
  using Member =
      std::variant<double Params::*, int Params::*, bool Params::*, std::string Params::*>;

  std::string_view name;
  Member member;
  int since = 0;
  std::string_view unit;
  std::string_view effect;
};

template <typename Params>
using ParameterTable = std::vector<Parameter<Params>>;

/// The rows in the alphabetical order in which the server sends them.
template <typename Params>
ParameterTable<Params> sorted_by_name(ParameterTable<Params> table) {
  std::sort(table.begin(), table.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return table;
}

template <typename Params>
const Parameter<Params>* find_parameter(const ParameterTable<Params>& table,
                                        std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const auto& row) { return row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

namespace detail {
// Text to value with the server's rules (server-protocol 10.2): on/off/true/false/0/1 for bool,
// a real without fraction for int, quotes optional for strings.
base::Result<void> assign(double& value, std::string_view text);
base::Result<void> assign(int& value, std::string_view text);
base::Result<void> assign(bool& value, std::string_view text);
base::Result<void> assign(std::string& value, std::string_view text);
}  // namespace detail

/// Sets the parameter `name` of `params` from text. An unknown name is an error that suggests the
/// nearest one; a value of the wrong kind is an error that names parameter and value.
template <typename Params>
base::Result<void> set_parameter(Params& params, const ParameterTable<Params>& table,
                                 std::string_view name, std::string_view text) {
  const Parameter<Params>* row = find_parameter(table, name);
  if (row == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& known : table) names.push_back(known.name);
    std::string message = "unknown parameter '" + std::string(name) + "'";
    const std::string_view near = base::nearest_name(name, names);
    if (!near.empty()) message += "; did you mean '" + std::string(near) + "'?";
    return base::Error{std::move(message)};
  }
  const base::Result<void> done =
      std::visit([&](auto member) { return detail::assign(params.*member, text); }, row->member);
  if (!done) return base::Error{"parameter '" + std::string(name) + "': " + done.error().message};
  return {};
}

}  // namespace cls::soccer
