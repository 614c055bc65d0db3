// Why a match ended.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace cls::soccer {

/// Only kFinished makes a match valid. An invalid match is neither a draw nor a loss.
enum class EndReason {
  kFinished,       ///< game time or --cycles reached
  kCrashed,        ///< a Playmaker or process crashed during play
  kStalled,        ///< no new cycle for longer than the stall limit
  kLate,           ///< too many decisions missed in a row
  kRefused,        ///< a Playmaker or server was unreachable or refused before the first cycle
  kProtocolError,  ///< a reply that cannot be parsed
  kServerFailed,   ///< the soccer server crashed or exited
  kTimedOut,       ///< the time limit of the whole match
  kInterrupted,    ///< SIGINT or SIGTERM
};

/// What follows from a reason.
struct EndReasonRow {
  struct Traits {
    bool expectable = false;   ///< a scenario may expect it
    bool by_intruder = false;  ///< a client in the place of another side may have caused it
  };

  EndReason reason;
  std::string_view name;  ///< in result.json and events.jsonl: "protocol_error"
  int exit_code;          ///< of `cls match`
  Traits traits;
};

/// All reasons, in the order of the enum.
std::span<const EndReasonRow> end_reasons();
const EndReasonRow& row_of(EndReason reason);

/// Its name in result.json and events.jsonl, such as "protocol_error".
std::string_view name(EndReason reason);

/// The reason of this name, if there is one.
std::optional<EndReason> parse_end_reason(std::string_view name);

}  // namespace cls::soccer
