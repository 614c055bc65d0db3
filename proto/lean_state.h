// LEAN_STATES of team_playmaker.proto: a State without the players that it has twice.
#pragma once

#include <string>

#include "proto/playmaker.pb.h"

namespace cls::proto {

/// Serializes `state` without the entries of our_players_dict and their_players_dict that equal the
/// first player of `teammates` or `opponents` with that number. Map entries are sorted by key.
/// Replaces `bytes`; `whole` is memory for the State with all entries. Both are reused.
void write_lean(const protos::State& state, std::string& whole, std::string& bytes);

/// Adds to the dictionaries the players of `teammates` and `opponents` whose number has no entry.
/// A State with all entries stays as it is.
void complete(protos::State& state);

}  // namespace cls::proto
