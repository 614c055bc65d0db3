// Classifies server messages by their first token.
#pragma once

#include <cstdint>
#include <string_view>

namespace cls::soccer {

/// The parser for a server message.
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

/// Reads the first token only; the message may still be malformed.
MessageKind message_kind(std::string_view message);

}  // namespace cls::soccer
