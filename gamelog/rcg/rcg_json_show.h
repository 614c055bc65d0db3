// Reading the shows of JSON logs.
#pragma once

#include "base/text/json_cursor.h"
#include "gamelog/record/frame.h"

namespace cls::gamelog {

/// Reads what follows behind the opening bracket of a show. Players that are not in it are not
/// connected; mode and teams, which monitors have in their shows, are left to the records of their
/// own. Without a stopped clock Frame::stopped is 0.
bool read_json_show(base::JsonCursor& in, Frame& frame);

/// "l" or "r"; any other word is neutral.
bool read_side(base::JsonCursor& in, soccer::Side& side);

}  // namespace cls::gamelog
