// Requested actions and planned actions as one line of text, for people.
#pragma once

#include <string>

#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"

namespace cls::match {

/// "body_go_to_point target_point=(12.3, -4) max_dash_power=100": the name of the action and its
/// fields that differ from their default. Numbers have three digits or all before the decimal
/// point, texts at most 120 bytes.
std::string action_text(const protos::PlayerAction& action);

/// A line for each action that the planner considered first, best first: "* pass strictLead 9
/// (12.3, -4) 45.2", with the value of the best sequence that begins with it. `*` marks the chosen
/// one. At most eight lines; empty without a plan.
std::string plan_text(const player::PlanChoice& choice);

}  // namespace cls::match
