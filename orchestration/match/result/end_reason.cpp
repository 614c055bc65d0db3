// Names of end reasons.
#include "orchestration/match/result/end_reason.h"

namespace cls::orchestration::match {

std::string_view name(EndReason reason) {
  switch (reason) {
    case EndReason::kFinished:
      return "finished";
    case EndReason::kCrashed:
      return "crashed";
    case EndReason::kStalled:
      return "stalled";
    case EndReason::kLate:
      return "late";
    case EndReason::kRefused:
      return "refused";
    case EndReason::kProtocolError:
      return "protocol_error";
    case EndReason::kServerFailed:
      return "server_failed";
    case EndReason::kTimedOut:
      return "timed_out";
    case EndReason::kInterrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace cls::orchestration::match
