// Scripted players: teammates and opponents whose actions the caller does not choose.
#pragma once

#include "training/scene/cast.h"
#include "training/skills/skills.h"

namespace cls::training {

/// A player of the team that attacks, defends or keeps goal, whatever the situation asks for. A
/// pure function of the scene.
PlayerCommand scripted_command(const PointOfView& view);

}  // namespace cls::training
