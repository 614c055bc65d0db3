// States to ask a Playmaker with: an ordinary one, and what else the wire allows.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::orchestration::checks {

/// An ordinary moment of play_on for the agent that `identity` names: 22 players, all seen, the
/// ball near the centre.
protos::State ordinary_state(const protos::RegisterResponse& identity, int cycle);

/// Every player and the ball out of sight for ever, all ages 1000; `unseen` in each coordinate of
/// what was never seen (upstream sends infinity there, we send 0).
void forget_everything(protos::State& state, float unseen);

/// Empties what IDL 1.8 to 1.10 added, as an older proxy would.
void remove_newer_fields(protos::State& state);

/// Adds fields that no version has, as a newer proxy might, on three levels.
void add_unknown_fields(protos::State& state);

/// A request of the planner with that many candidates, numbered from 1.
protos::BestPlannerActionRequest planner_request(const protos::State& state, int candidates);

}  // namespace cls::orchestration::checks
