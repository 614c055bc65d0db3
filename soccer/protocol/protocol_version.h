// Which versions of the text protocol are spoken here.
#pragma once

namespace cls::soccer {

/// Oldest and newest client versions whose messages can be written and read (rcssserver 19).
/// A version of 18.9 counts as 18. For "everything" see kAllVersions in soccer/parameter.h.
constexpr int kOldestProtocolVersion = 14;

/// Oldest version whose messages can be written: of clients that our server lets in.
constexpr int kOldestServedVersion = 8;
constexpr int kNewestProtocolVersion = 19;

/// What our own agents speak.
constexpr int kDefaultProtocolVersion = 18;

}  // namespace cls::soccer
