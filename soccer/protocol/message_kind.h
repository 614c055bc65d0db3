// Telling server messages apart by their first word.
#pragma once

#include <cstdint>
#include <string_view>

namespace cls::soccer {

/// Which parser a server message belongs to.
enum class MessageKind : std::uint8_t {
  kSenseBody,
  kSee,
  kHear,
  kFullState,
  kGlobalView,  ///< see_global and (ok look ...)
  kServerParam,
  kPlayerParam,
  kPlayerType,
  kReply,  ///< everything in server_reply.h
  kUnknown,
};

/// Looks at the first word only; the message may still be malformed.
MessageKind message_kind(std::string_view message);

}  // namespace cls::soccer
