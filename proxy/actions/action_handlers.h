// Table of action handlers, one per member of PlayerAction.
#pragma once

#include "proto/playmaker.pb.h"
#include "proxy/planner/reply_context.h"

namespace cls::proxy {

/// Main actions: the first success ends them. Side actions always run.
enum class ActionClass : unsigned char { kMain, kSide };

/// True when the action succeeded. The named member is set and its numbers are finite.
using ActionHandler = bool (*)(const protos::PlayerAction& action, ReplyContext& context);

struct ActionEntry {
  protos::PlayerAction::ActionCase member;
  ActionClass kind;
  ActionHandler handler;  ///< null: no member
};

/// The entry of a member; for unknown values the entry of ACTION_NOT_SET, which has no handler.
const ActionEntry& action_entry(int member);

}  // namespace cls::proxy
