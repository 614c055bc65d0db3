// Escaping for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// Escapes text for element content and double-quoted attribute values. Control characters and
/// invalid UTF-8, which XML cannot represent, become '?'.
std::string escape_xml(std::string_view text);

}  // namespace cls::base
