// What is heard: the referee, and what others say.
#pragma once

#include <string_view>

#include "proxy/world/world_model.h"
#include "soccer/messages/hear.h"

namespace cls::proxy {

/// Takes a referee's word into clock, mode, score and shoot-out; the ball is put where the new mode
/// puts it. Words that are neither a mode nor a known event change nothing.
void hear_referee(WorldModel& world, int time, std::string_view word);

/// Keeps what a player or coach said for the decision of this moment.
void hear_message(WorldModel& world, const soccer::Hear& hear);

}  // namespace cls::proxy
