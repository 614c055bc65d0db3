// Text as XML and HTML hold it.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// For the content of an element and for a value in double quotes. What XML cannot hold at all,
/// control characters and bytes that are no UTF-8, becomes '?'.
std::string xml_escaped(std::string_view text);

}  // namespace cls::base
