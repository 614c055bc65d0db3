// Context in which actions are executed.
#pragma once

#include "proxy/commands/command_slots.h"
#include "proxy/connection/action_report.h"
#include "proxy/looking/neck.h"
#include "proxy/planner/action_memory.h"
#include "proxy/planner/plan.h"
#include "proxy/world/world_model.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

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
  const protos::PlayerActions* reply = nullptr;  ///< action list; null without a reply
};

}  // namespace cls::proxy
