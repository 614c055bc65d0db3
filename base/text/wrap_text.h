// Line wrapping.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cls::base {

/// Replaces spaces with line feeds so that no line is longer than `width` characters; longer words
/// get their own line. Keeps existing line feeds.
std::string wrap_text(std::string_view text, std::size_t width);

/// Wraps text that starts in column `indent` and continues there on the following lines.
std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent);

}  // namespace cls::base
