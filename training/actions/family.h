// Families of actions without parameters: the same command for each of a list of values.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "training/actions/action_set.h"

namespace cls::training {

/// A name that lives as long as the program.
inline std::string_view stored(std::string name) {
  static std::deque<std::string> names;
  return names.emplace_back(std::move(name));
}

/// What the legality of an action of `Family` asks: kLegal, the same for all indices (null: always
/// legal), or legal() of the index.
template <typename Family, std::size_t kIndex>
constexpr Condition legality() {
  if constexpr (requires { Family::kLegal; }) {
    return Family::kLegal;
  } else {
    return [](const PointOfView& view) { return Family::legal(view, kIndex); };
  }
}

template <typename Family, std::size_t... kIndices>
void append_family(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back(
       {stored(Family::name(kIndices)),
        {},
        [](const PointOfView& view, const float*) { return Family::command(view, kIndices); },
        legality<Family, kIndices>()}),
   ...);
}

/// Appends the actions of `Family`, which has static functions of an index below kCount: name() and
/// command(), and legal() or a constant kLegal (see legality()).
template <typename Family>
void append_family(std::vector<Action>& out) {
  append_family<Family>(out, std::make_index_sequence<Family::kCount>());
}

}  // namespace cls::training
