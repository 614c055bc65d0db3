// Parses the shows of JSON logs.
#pragma once

#include "base/text/json_cursor.h"
#include "gamelog/record/frame.h"

namespace cls::gamelog {

/// Parses a show after its opening bracket. Players that it lacks are not connected. Mode and
/// teams, which shows of monitors contain, are ignored. Frame::stopped is 0 if the show has none.
bool read_json_show(base::JsonCursor& in, Frame& frame);

/// "l" or "r"; any other string is neutral.
bool read_side(base::JsonCursor& in, soccer::Side& side);

}  // namespace cls::gamelog
