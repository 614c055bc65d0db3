// Writing a tile.
#include "simulator/sessions/tile.h"

#include "base/text/number_text.h"

namespace cls::simulator {

std::string text_of(const Tile& tile) {
  std::string text = tile.side == soccer::Side::kLeft ? "(team_graphic_l (" : "(team_graphic_r (";
  base::append_int(tile.graphic.x, text);
  text.push_back(' ');
  base::append_int(tile.graphic.y, text);
  for (const std::string& line : tile.graphic.xpm) text.append(" \"").append(line).push_back('"');
  text.push_back(')');
  return text;
}

}  // namespace cls::simulator
