// Reading the shows of JSON logs.
#pragma once

#include "gamelog/frame.h"
#include "gamelog/json_cursor.h"

namespace cls::gamelog {

/// Reads what follows behind the opening bracket of a show. Players that are not in it are not
/// connected; mode and teams, which monitors have in their shows, are left to the records of their
/// own. Without a stopped clock Frame::stopped is 0.
bool read_json_show(JsonCursor& in, Frame& frame);

/// "l" or "r"; any other word is neutral.
bool read_side(JsonCursor& in, soccer::Side& side);

}  // namespace cls::gamelog
