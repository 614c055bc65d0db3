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

template <typename Family, std::size_t... kIndices>
void append_family(std::vector<Action>& out, std::index_sequence<kIndices...>) {
  (out.push_back(
       {stored(Family::name(kIndices)),
        {},
        [](const PointOfView& view, const float*) { return Family::command(view, kIndices); },
        [](const PointOfView& view) { return Family::legal(view, kIndices); }}),
   ...);
}

/// Appends the actions of `Family`, which has static functions of an index below kCount: name(),
/// command() and legal().
template <typename Family>
void append_family(std::vector<Action>& out) {
  append_family<Family>(out, std::make_index_sequence<Family::kCount>());
}

}  // namespace cls::training
