// Types and functions of soccer/ that all of player/ uses by their short names.
#pragma once

#include "soccer/angle.h"
#include "soccer/geometry.h"
#include "soccer/math.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::player {

using soccer::AngleDeg;
using soccer::PlayMode;
using soccer::Side;
using soccer::Vec2;

namespace math = soccer::math;

}  // namespace cls::player
