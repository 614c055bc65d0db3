// Tiles of the team graphics that coaches send and monitors show.
#pragma once

#include <string>

#include "base/text/number_text.h"
#include "soccer/commands/coach_command.h"
#include "soccer/side.h"

namespace cls::simulator {

struct TeamGraphicTile {
  soccer::Side side = soccer::Side::kLeft;
  soccer::TeamGraphic graphic;
};

/// The message in game logs and to monitors: `(team_graphic_l (X Y "8 8 2 1" ...)`. The last
/// bracket is missing, as in rcssserver.
inline std::string format_tile(const TeamGraphicTile& tile) {
  std::string text = tile.side == soccer::Side::kLeft ? "(team_graphic_l (" : "(team_graphic_r (";
  base::append_int(tile.graphic.x, text);
  text.push_back(' ');
  base::append_int(tile.graphic.y, text);
  for (const std::string& line : tile.graphic.xpm) text.append(" \"").append(line).push_back('"');
  text.push_back(')');
  return text;
}

}  // namespace cls::simulator
