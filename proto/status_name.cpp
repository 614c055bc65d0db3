// The 17 status codes of gRPC.
#include "proto/status_name.h"

namespace cls::proto {

const std::vector<std::string_view>& status_names() {
  static const std::vector<std::string_view> names = {"OK",
                                                      "CANCELLED",
                                                      "UNKNOWN",
                                                      "INVALID_ARGUMENT",
                                                      "DEADLINE_EXCEEDED",
                                                      "NOT_FOUND",
                                                      "ALREADY_EXISTS",
                                                      "PERMISSION_DENIED",
                                                      "RESOURCE_EXHAUSTED",
                                                      "FAILED_PRECONDITION",
                                                      "ABORTED",
                                                      "OUT_OF_RANGE",
                                                      "UNIMPLEMENTED",
                                                      "INTERNAL",
                                                      "UNAVAILABLE",
                                                      "DATA_LOSS",
                                                      "UNAUTHENTICATED"};
  return names;
}

std::string_view status_name(int code) {
  const auto index = static_cast<std::size_t>(code);
  return status_names()[code >= 0 && index < status_names().size() ? index : kStatusUnknown];
}

}  // namespace cls::proto
