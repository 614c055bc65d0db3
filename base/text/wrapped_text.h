// Text in lines of a limited width.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::base {

/// `text` with line feeds in place of blanks, so that no line is longer than `width`; a longer word
/// has a line of its own. Lines that are there already stay.
std::string wrapped(std::string_view text, std::size_t width);

}  // namespace cls::base
