// The bracket of a knockout as text and HTML.
#pragma once

#include <cstddef>
#include <string>

#include "tournament/report/report_model.h"

namespace cls::tournament {

/// A tree: the final at its root, below each tie those that its entrants won. Lines are wrapped at
/// `width`. Empty without a bracket.
std::string bracket_text(const Report& report, std::size_t width);

/// A column of ties per round, styled by kBracketStyle. Empty without a bracket.
std::string bracket_html(const Report& report);

extern const char* const kBracketStyle;

}  // namespace cls::tournament
