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

/// The condition of an action of `Family`: kLegal, the same for all indices, or legal() of the
/// index; null (always legal) without either.
template <typename Family, std::size_t kIndex>
constexpr Condition legality() {
  if constexpr (requires { Family::kLegal; }) return Family::kLegal;
  if constexpr (requires { &Family::legal; }) {
    return [](const PointOfView& view) { return Family::legal(view, kIndex); };
  }
  return nullptr;
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
/// command(), and may have legal() or a constant kLegal (see legality()).
template <typename Family>
void append_family(std::vector<Action>& out) {
  append_family<Family>(out, std::make_index_sequence<Family::kCount>());
}

}  // namespace cls::training
