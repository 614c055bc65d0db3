// The parts of a decision that are not actions of a Playmaker (docs/spec/proxy-behavior.md 2.3).
#pragma once

#include "player/planner/action_context.h"

namespace cls::player {

/// Which automatic actions may replace the Playmaker's, in the order in which they are tried.
struct AutomaticPlay {
  bool preprocess = true;
  bool sure_shot = true;
  bool intention = true;
  bool force_kick = true;
  bool heard_pass = true;
};

/// True when the proxy acts automatically before the Playmaker's actions: frozen, before kick-off,
/// after goals, own position or ball unknown. Sent as State.need_preprocess.
bool needs_preprocess(const WorldModel& world);

// One decision: begin_decision(), then play_automatically() or else actions, then
// finish_decision().

void begin_decision(ActionContext& context);
/// True if an automatic action was taken.
bool play_automatically(ActionContext& context, const AutomaticPlay& enabled);
/// Queued neck plan, default view width and focus, communication.
void finish_decision(ActionContext& context);

/// The whole decision when no reply arrived: preprocess or looking at the ball.
void decide_without_reply(ActionContext& context);

}  // namespace cls::player
