// JSON values in assertions: their order as numbers, and their text.
#pragma once

#include <compare>
#include <ostream>

#include "base/text/json.h"

namespace cls::base {

inline std::partial_ordering operator<=>(const Json& left, double right) {
  return left.get<double>() <=> right;
}
inline std::partial_ordering operator<=>(const Json& left, const Json& right) {
  return left <=> right.get<double>();
}

inline std::ostream& operator<<(std::ostream& out, const Json& json) { return out << json.dump(); }

}  // namespace cls::base
