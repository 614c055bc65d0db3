// The names of stages and their parts: "first round, group C".
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace cls::league {

/// The stage of a match (Fixture::stage). Names of stages have no comma.
struct StageName {
  std::string stage;  ///< "first round", "last 16"
  std::string part;   ///< a group, leg or tie: "group C", "tie 3"; empty: the stage has none

  std::string text() const {
    if (stage.empty() || part.empty()) return stage + part;
    return fmt::format("{}, {}", stage, part);
  }
};

inline StageName parse_stage_name(std::string_view text) {
  constexpr std::string_view kSeparator = ", ";
  const std::size_t comma = text.find(kSeparator);
  if (comma == text.npos) return {std::string(text), ""};
  return {std::string(text.substr(0, comma)), std::string(text.substr(comma + kSeparator.size()))};
}

/// True when a match whose Fixture::stage is `text` belongs to the stage `name`.
inline bool belongs_to(std::string_view text, std::string_view name) {
  return parse_stage_name(text).stage == name;
}

}  // namespace cls::league
