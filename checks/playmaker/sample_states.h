// Sample States for a Playmaker: an ordinary one and edge cases of the wire.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::checks {

/// An ordinary State in play_on for the agent `identity`: 22 players, all seen, ball near the
/// center.
protos::State ordinary_state(const protos::RegisterResponse& identity, int cycle);

/// No player and no ball ever seen: all ages 1000, all coordinates `unseen` (upstream sends
/// infinity, cls sends 0).
void forget_everything(protos::State& state, float unseen);

/// Clears the fields added in IDL 1.8 to 1.10, as sent by an older proxy.
void remove_newer_fields(protos::State& state);

/// Adds unknown fields on three levels, as sent by a newer proxy.
void add_unknown_fields(protos::State& state);

/// A planner request with this number of candidates, numbered from 1.
protos::BestPlannerActionRequest planner_request(const protos::State& state, int candidates);

}  // namespace cls::checks
