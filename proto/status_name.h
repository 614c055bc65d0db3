// gRPC status codes, for code that does without gRPC, and their names.
#pragma once

#include <string_view>
#include <vector>

namespace cls::proto {

// The codes that have a meaning of their own here.
inline constexpr int kStatusOk = 0;
inline constexpr int kStatusCancelled = 1;
inline constexpr int kStatusUnknown = 2;
inline constexpr int kStatusDeadlineExceeded = 4;
inline constexpr int kStatusUnimplemented = 12;
inline constexpr int kStatusUnavailable = 14;

/// "OK", "CANCELLED", "UNKNOWN", ... in the order of their codes, which begin at 0.
const std::vector<std::string_view>& status_names();

/// The name of a status code. A code that gRPC does not define is "UNKNOWN", as in gRPC itself.
std::string_view status_name(int code);

}  // namespace cls::proto
