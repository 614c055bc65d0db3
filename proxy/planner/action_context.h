// What the carrying out of an action works on.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/connection/action_report.h"
#include "proxy/looking/neck_plan.h"
#include "proxy/planner/action_memory.h"
#include "proxy/planner/plan.h"
#include "proxy/world/world_model.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

/// The plan of a decision, and who chooses from it.
struct PlanChoice {
  enum class Chooser : unsigned char {
    kProxy,     ///< nobody to ask: the plan's own best
    kOpen,      ///< the Playmaker may be asked
    kWanted,    ///< the Playmaker must be asked before the decision can go on
    kAnswered,  ///< `node` is its answer
  };
  Chooser chooser = Chooser::kProxy;
  int node = -1;  ///< index of the chosen node; negative when the Playmaker did not answer
  Plan plan;      ///< empty until it is needed
};

struct ActionContext {
  const WorldModel& world;
  ActionMemory& memory;
  CommandSlots& slots;
  NeckPlan& neck;  ///< queued look; the last one stands
  ActionReport& report;
  PlanChoice& choice;
  const protos::PlayerActions* reply = nullptr;  ///< the list; null without an answer
};

}  // namespace cls::proxy
