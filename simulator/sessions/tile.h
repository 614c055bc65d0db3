// A piece of the picture that a team shows on monitors.
#pragma once

#include <string>

#include "soccer/commands/coach_command.h"
#include "soccer/side.h"

namespace cls::simulator {

struct Tile {
  soccer::Side side = soccer::Side::kLeft;
  soccer::TeamGraphic graphic;
};

/// As game logs and monitors show it: `(team_graphic_l (X Y "8 8 2 1" ...)`, with one bracket too
/// few, as in the real server.
std::string text_of(const Tile& tile);

}  // namespace cls::simulator
