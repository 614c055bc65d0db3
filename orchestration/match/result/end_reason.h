// Why a match ended.
#pragma once

#include <string_view>

namespace cls::orchestration::match {

/// Everything but kFinished makes a match invalid: it is then neither a draw nor a loss.
enum class EndReason {
  kFinished,       ///< game time or --cycles reached
  kCrashed,        ///< a Playmaker or process died in play
  kStalled,        ///< no new cycle for longer than the stall limit
  kLate,           ///< too many decisions missed in a row
  kRefused,        ///< a Playmaker or server was not reached, or said no, before the first cycle
  kProtocolError,  ///< an answer that cannot be understood
  kServerFailed,   ///< the soccer server died or ended by itself
  kTimedOut,       ///< the time limit of the whole match
  kInterrupted,    ///< SIGINT or SIGTERM
};

/// The word in result.json and events.jsonl, such as "protocol_error".
std::string_view name(EndReason reason);

}  // namespace cls::orchestration::match
