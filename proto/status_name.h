// Names of gRPC status codes.
#pragma once

#include <string_view>
#include <vector>

namespace cls::proto {

/// "OK", "CANCELLED", "UNKNOWN", ... in the order of their codes, which begin at 0.
const std::vector<std::string_view>& status_names();

/// The name of a status code. A code that gRPC does not define is "UNKNOWN", as in gRPC itself.
std::string_view status_name(int code);

}  // namespace cls::proto
