// Context in which the actions of a reply are executed.
#pragma once

#include "player/planner/action_context.h"

namespace protos {
class PlayerActions;
}

namespace cls::proxy {

struct ReplyContext : player::ActionContext {
  const protos::PlayerActions& reply;
};

}  // namespace cls::proxy
