// Replies of Playmakers as texts of the decision debugger: actions, plans, drawings.
#pragma once

#include <string>

#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"

namespace cls::match {

/// "body_go_to_point target_point=(12.3, -4) max_dash_power=100": the name of the action and its
/// fields that differ from their default. Numbers have three digits or all before the decimal
/// point, texts at most 120 bytes.
std::string action_text(const protos::PlayerAction& action);

/// What the player considered; `*` marks what was chosen, empty: nothing. A line for each action
/// that the planner considered first, best first, with the value of the best sequence that begins
/// with it: "* pass 9 (12.3, -4) 45.2", at most eight lines. Or one for each option that a policy
/// may choose, by id, with its probability, the receiver of a pass, and where known its target and
/// the room around that: "* through pass 9 (12.3, -4) 45.2% room 3.1".
std::string plan_text(const player::PlanChoice& choice);

/// The `log` and `debug_client` actions of a reply in the lines of a debug log (docs/actions.md),
/// without the time and with numbers of two decimals: "1024 c 12.3 -4 2 red". Empty: none. What
/// does not fit into a recorded text is left out.
std::string drawings_text(const protos::PlayerActions& reply);

/// True for an action that shows something and does nothing else.
bool is_drawing(const protos::PlayerAction& action);

}  // namespace cls::match
