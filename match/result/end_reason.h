// Why a match ended.
#pragma once

#include <optional>
#include <string_view>

namespace cls::match {

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

/// Its name in result.json and events.jsonl, such as "protocol_error".
std::string_view name(EndReason reason);

/// The reason of this name, if there is one.
std::optional<EndReason> parse_end_reason(std::string_view name);

}  // namespace cls::match
