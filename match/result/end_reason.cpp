// The table of names of end reasons.
#include "match/result/end_reason.h"

#include <array>
#include <cstddef>

namespace cls::match {
namespace {

// In the order of EndReason.
constexpr std::array<std::string_view, 9> kNames = {"finished",      "crashed",   "stalled",
                                                    "late",          "refused",   "protocol_error",
                                                    "server_failed", "timed_out", "interrupted"};
static_assert(kNames.size() == static_cast<std::size_t>(EndReason::kInterrupted) + 1);

}  // namespace

std::string_view name(EndReason reason) { return kNames[static_cast<std::size_t>(reason)]; }

std::optional<EndReason> parse_end_reason(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<EndReason>(i);
  }
  return std::nullopt;
}

}  // namespace cls::match
