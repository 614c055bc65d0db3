// What a Playmaker wants said, in the words that helios teams understand.
#pragma once

#include <optional>

#include "proxy/perception/say_message.h"

namespace protos {
class Say;
}

namespace cls::proxy {

/// Nothing for a payload without a known member.
std::optional<SayMessage> say_message_of(const protos::Say& say,
                                         const soccer::ServerParams& server);

}  // namespace cls::proxy
