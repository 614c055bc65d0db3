// The formations that come with the proxy, as the text of their files.
#pragma once

#include <string_view>

namespace cls::proxy {

/// Text of `<name>.formation` in proxy/formation/built_in, put in by the build; empty for a name
/// that is not there.
std::string_view built_in_formation(std::string_view name);

}  // namespace cls::proxy
