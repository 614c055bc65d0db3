// Context in which actions are executed.
#pragma once

#include "player/commands/command_slots.h"
#include "player/looking/neck.h"
#include "player/planner/action_memory.h"
#include "player/planner/action_report.h"
#include "player/planner/plan.h"
#include "player/world/world_model.h"

namespace cls::player {

/// The plan of a decision, and the party that chooses its action.
struct PlanChoice {
  enum class Chooser : unsigned char {
    kProxy,      ///< the proxy: best node of the plan
    kPlaymaker,  ///< the Playmaker may choose
    kRequested,  ///< the Playmaker must choose before the decision continues
    kReplied,    ///< the Playmaker chose `node`
  };
  Chooser chooser = Chooser::kProxy;
  int node = -1;  ///< index of the chosen node; negative: no reply from the Playmaker
  Plan plan;      ///< empty until it is needed
};

struct ActionContext {
  const WorldModel& world;
  ActionMemory& memory;
  CommandSlots& slots;
  NeckPlan& neck;  ///< queued neck plan; the last one wins
  ActionReport& report;
  PlanChoice& choice;
};

}  // namespace cls::player
