// Paths in URLs.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// Replaces bytes that have a meaning in URLs, or end a link in Markdown, with %XX. "/" stays.
std::string percent_encoded(std::string_view path);

}  // namespace cls::base
