// A look that a behaviour wants once all commands of the body are chosen.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/world/sight_memory.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

/// At most one a decision; carried out after the action list, it replaces what the Playmaker set
/// (proxy behaviour 2.6).
struct NeckPlan {
  enum class Kind : unsigned char {
    kNone,
    kBall,
    kBallOrScan,
    kScan,
    kPoint,
    kGoalieOrScan,
    kOffensiveIntercept,
  };
  Kind kind = Kind::kNone;
  soccer::Vec2 point;  ///< for kPoint
};

/// False for kNone.
bool carry_out(const NeckPlan& plan, const WorldModel& world, const SightMemory& sight,
               CommandSlots& slots);

}  // namespace cls::proxy
