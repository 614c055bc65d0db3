// The graphic that a coach shows of its team.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "soccer/commands/coach_command.h"

namespace cls::proxy {

/// Tiles of 8 x 8 pixels, row by row, each with its own colors only.
using TeamGraphic = std::vector<soccer::TeamGraphic>;

/// Reads an X PixMap (`.xpm`, one character per pixel): width and height are multiples of 8, at
/// most 256 x 64. The error names the file and what is wrong with it.
base::Result<TeamGraphic> read_team_graphic(const std::string& path);

}  // namespace cls::proxy
