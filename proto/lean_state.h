// LEAN_STATES of team_playmaker.proto: a State without the players that it has twice.
#pragma once

#include "proto/playmaker.pb.h"

namespace cls::proto {

/// Adds to the dictionaries the players of `teammates` and `opponents` whose number has no entry.
/// A State with all entries stays as it is. StateWriter leaves them out.
void complete(protos::State& state);

}  // namespace cls::proto
