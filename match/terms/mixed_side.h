// `mix:AGENTS=SIDE;...`: which Playmaker decides for which agents of a team.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::match {

/// A part of a mixed side, as the user wrote it.
struct MixedPart {
  std::string label;          ///< "1", "2-5,9", "defenders"
  std::vector<int> agents{};  ///< agent numbers, ascending; 12: the coach
  std::string side;
};

/// Splits the text after `mix:`. Parts are separated by `;` before AGENTS=: numbers ("1", "2-5"),
/// roles (goalie, defenders, midfielders, forwards, players, coach) and `others`, separated by
/// commas. Each player belongs to one part; a coach without a part belongs to the first one. The
/// error names the part.
base::Result<std::vector<MixedPart>> parse_mixed_side(std::string_view text);

}  // namespace cls::match
