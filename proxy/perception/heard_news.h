// What teammates say about ball and players, taken into the beliefs.
#pragma once

#include <string_view>

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Takes the say messages in `text`, said by our player `speaker`, into ball and players: places
/// for what is not in sight, numbers for players whose number was not seen. What is heard counts as
/// one cycle old. Text that is no say message is left at where it stops making sense.
void take_news(WorldModel& world, int speaker, std::string_view text);

}  // namespace cls::proxy
