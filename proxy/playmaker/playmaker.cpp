// Names of outcomes.
#include "proxy/playmaker/playmaker.h"

#include <array>

namespace cls::proxy {

std::string_view name(RpcOutcome outcome) {
  static constexpr std::array<std::string_view, kRpcOutcomes> names = {
      "ok", "deadline", "unavailable", "unimplemented", "protocol error", "cancelled", "error"};
  return names.at(static_cast<std::size_t>(outcome));
}

}  // namespace cls::proxy
