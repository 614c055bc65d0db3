// Hear messages: referee messages and say messages.
#pragma once

#include <string_view>

#include "player/world/world_model.h"
#include "soccer/messages/hear.h"

namespace cls::player {

/// Updates play mode, score, shoot-out and ball position by a referee message. Ignores unknown
/// messages.
void hear_referee(WorldModel& world, int time, std::string_view message);

/// Handles a say message: stores it for the current decision, and updates estimates by teammates
/// and coach.
void hear_message(WorldModel& world, const soccer::Hear& hear);

/// Updates ball and players by the say messages in `text` of teammate `speaker`: positions of
/// unseen objects, numbers of unnumbered players. Heard values have age 1. Stops at the first
/// invalid message.
void apply_say_messages(WorldModel& world, int speaker, std::string_view text);

}  // namespace cls::player
