// Who has the ball, and who kicked it last.
#pragma once

#include "proxy/world/world_model.h"

namespace cls::proxy {

/// Fills kickable_teammate_id and kickable_opponent_id (proxy behaviour 3.7).
void find_kickers(WorldModel& world);

/// Updates last_kick from own kicks, kicking marks, and jumps of the ball's velocity while only
/// one team could reach it. Uses the kickers found for the previous decision; call it before
/// find_kickers.
void find_last_kick(WorldModel& world);

}  // namespace cls::proxy
