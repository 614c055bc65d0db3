// The table of end reasons.
#include "soccer/end_reason.h"

#include <algorithm>

#include "base/index.h"

namespace cls::soccer {
namespace {

constexpr int kInvalid = 1;  // the exit code of an invalid match

// In the order of the enum.
constexpr EndReasonRow kRows[] = {
    {EndReason::kFinished, "finished", 0, {.expectable = true}},
    {EndReason::kCrashed, "crashed", kInvalid, {.expectable = true, .by_intruder = true}},
    {EndReason::kStalled, "stalled", kInvalid, {.expectable = true, .by_intruder = true}},
    {EndReason::kLate, "late", kInvalid, {.expectable = true, .by_intruder = true}},
    {EndReason::kRefused, "refused", 69, {.expectable = true, .by_intruder = true}},
    {EndReason::kProtocolError, "protocol_error", kInvalid, {.expectable = true}},
    {EndReason::kServerFailed, "server_failed", kInvalid, {.by_intruder = true}},
    {EndReason::kTimedOut, "timed_out", 124, {.expectable = true}},
    {EndReason::kInterrupted, "interrupted", 130, {}},
};

}  // namespace

std::span<const EndReasonRow> end_reasons() { return kRows; }

const EndReasonRow& row_of(EndReason reason) { return kRows[base::index(reason)]; }

std::string_view name(EndReason reason) { return row_of(reason).name; }

std::optional<EndReason> parse_end_reason(std::string_view name) {
  const auto* row = std::ranges::find(kRows, name, &EndReasonRow::name);
  return row == std::end(kRows) ? std::nullopt : std::optional(row->reason);
}

}  // namespace cls::soccer
