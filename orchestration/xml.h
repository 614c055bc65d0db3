// Text as XML and HTML hold it.
#pragma once

#include <string>
#include <string_view>

namespace cls::orchestration {

/// For the content of an element and for a value in double quotes. Control characters that XML
/// cannot hold at all become '?'.
std::string xml_escaped(std::string_view text);

}  // namespace cls::orchestration
