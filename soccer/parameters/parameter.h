// Parameter tables: rows, lookup by name, values from text.
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

/// Clients receive the parameters of their version and older; monitors and game logs receive all.
constexpr int kAllVersions = 999;

/// One row of a parameter table: the member, the first client version that receives it, and its
/// unit and effect for help texts.
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

/// Rows in alphabetical order, as the server sends them.
template <typename Params>
ParameterTable<Params> sorted_by_name(ParameterTable<Params> table) {
  std::ranges::sort(table, {}, &Parameter<Params>::name);
  return table;
}

template <typename Params>
const Parameter<Params>* find_parameter(const ParameterTable<Params>& table,
                                        std::string_view name) {
  const auto found = std::ranges::find(table, name, &Parameter<Params>::name);
  return found == table.end() ? nullptr : &*found;
}

namespace detail {
// Parse values by the rules of the server (docs/spec/server-protocol.md 10.2):
// on/off/true/false/0/1 for bool, a real number without fraction for int, optional quotes for
// strings.
base::Result<void> assign(double& value, std::string_view text);
base::Result<void> assign(int& value, std::string_view text);
base::Result<void> assign(bool& value, std::string_view text);
base::Result<void> assign(std::string& value, std::string_view text);
}  // namespace detail

/// Sets the parameter `name` of `params` from text. Errors: an unknown name, with a suggestion; a
/// value of the wrong type, with parameter and value.
template <typename Params>
base::Result<void> set_parameter(Params& params, const ParameterTable<Params>& table,
                                 std::string_view name, std::string_view text) {
  const Parameter<Params>* row = find_parameter(table, name);
  if (row == nullptr) {
    std::vector<std::string_view> names;
    for (const auto& known : table) names.push_back(known.name);
    std::string message = "unknown parameter '" + std::string(name) + "'";
    const std::string_view nearest = base::nearest_name(name, names);
    if (!nearest.empty()) message += "; did you mean '" + std::string(nearest) + "'?";
    return base::Error{std::move(message)};
  }

  const base::Result<void> done =
      std::visit([&](auto member) { return detail::assign(params.*member, text); }, row->member);
  if (!done) return base::Error{"parameter '" + std::string(name) + "': " + done.error().message};
  return {};
}

}  // namespace cls::soccer
