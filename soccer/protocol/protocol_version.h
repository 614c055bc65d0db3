// Supported versions of the text protocol.
#pragma once

namespace cls::soccer {

/// Range of client versions whose messages can be formatted and parsed (rcssserver 19).
/// Version 18.9 counts as 18.
constexpr int kMinProtocolVersion = 14;
constexpr int kMaxProtocolVersion = 19;

/// Oldest version of clients that the embedded server accepts; older than kMinProtocolVersion,
/// because their messages can be formatted.
constexpr int kMinServedVersion = 8;

/// Version of the cls agents.
constexpr int kDefaultProtocolVersion = 19;

}  // namespace cls::soccer
