// Positions of players at a kick-off.
#pragma once

#include "training/scene/scene.h"

namespace cls::training {

/// In the own half, server coordinates.
Vec2 kick_off_position(int slot);

}  // namespace cls::training
