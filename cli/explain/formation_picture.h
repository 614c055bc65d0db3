// A formation as a picture in the terminal and as SVG.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/result.h"
#include "player/formation/formation.h"
#include "soccer/geometry.h"

namespace cls::cli {

/// A formation to draw, with the ball at one place.
struct FormationPicture {
  std::string name;  ///< "normal-formation", or the file
  soccer::Vec2 ball;
  player::TeamPoints players;
};

/// Names of the built-in formations: "before-kick-off", "normal-formation", ...
std::vector<std::string> formation_names();

/// `name` is a built-in formation, also its beginning ("offense"), or a file in any format that a
/// team may have. The error names file and line, or the built-in formations.
base::Result<FormationPicture> find_formation(const std::string& name, soccer::Vec2 ball);

/// Field, players as 1 to 9, A and B, and a table of their places.
std::string formation_text(const FormationPicture& picture, std::size_t width);

/// The text of an SVG file.
std::string formation_svg(const FormationPicture& picture);

}  // namespace cls::cli
