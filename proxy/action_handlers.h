// The table of actions: for each member of PlayerAction how it is carried out.
#pragma once

#include "proto/playmaker.pb.h"
#include "proxy/action_memory.h"
#include "proxy/action_report.h"
#include "proxy/command_slots.h"
#include "proxy/skills/neck_plan.h"
#include "proxy/world_model.h"

namespace cls::proxy {

/// What a handler works on.
struct ActionContext {
  const WorldModel& world;
  ActionMemory& memory;
  CommandSlots& slots;
  NeckPlan& neck;  ///< queued look; the last one stands
  ActionReport& report;
};

/// Main actions exclude each other, the first success wins; side actions always run.
enum class ActionClass : unsigned char { kMain, kSide };

/// True when the action succeeded. The named member is set and its numbers are finite.
using ActionHandler = bool (*)(const protos::PlayerAction& action, ActionContext& context);

struct ActionEntry {
  protos::PlayerAction::ActionCase member;
  ActionClass kind;
  ActionHandler handler;  ///< null: not implemented
};

/// The entry of a member; for a value that is no member the entry of ACTION_NOT_SET, which has no
/// handler.
const ActionEntry& action_entry(int member);

}  // namespace cls::proxy
