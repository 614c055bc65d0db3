// What an agent does before it listens to its Playmaker: when it cannot play, or not yet.
#pragma once

#include <optional>

#include "proxy/commands/command_slots.h"
#include "proxy/looking/neck_plan.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// The reason, in the order of precedence (proxy behaviour 2.4).
enum class PreprocessReason : unsigned char { kFrozen, kNoPlay, kPlaceUnknown, kBallLost };

std::optional<PreprocessReason> preprocess_reason(const WorldModel& world);

/// Acts on that reason.
void preprocess(PreprocessReason reason, const WorldModel& world, const SightMemory& sight,
                CommandSlots& slots, NeckPlan& neck);

}  // namespace cls::proxy
