// Converts a Playmaker's Say action into a say message in the helios format.
#pragma once

#include <optional>

#include "player/perception/say_message.h"

namespace protos {
class Say;
}

namespace cls::proxy {

/// nullopt for a Say without a known member.
std::optional<player::SayMessage> say_message_of(const protos::Say& say,
                                                 const soccer::ServerParams& server);

}  // namespace cls::proxy
