// The server:: parameters of rcssserver: a struct and a table, both generated from one list.
#pragma once

#include <string>

#include "soccer/parameters/parameter.h"

namespace cls::soccer {

/// Every server:: parameter of rcssserver 19 with its default (docs/spec/server-protocol.md 10.3).
/// Members are named as on the wire. half_time and extra_half_time are in seconds, as users write
/// them; use the functions below for cycles.
struct ServerParams {
#define CLS_SERVER_PARAM(type, name, value, since, unit, effect) type name = value;
#include "soccer/parameters/server_params.inc"
#undef CLS_SERVER_PARAM

  /// Length of a normal half in cycles; zero or negative: no time limit.
  int half_time_cycles() const;
  /// Length of an extra half in cycles.
  int extra_half_time_cycles() const;
  /// End of normal time, and of extra time, in cycles; of at most kMaxHalfs halves each.
  int normal_time_cycles() const;
  int total_time_cycles() const;
};

/// More halves than any match has; so many of the longest ones fit an int.
inline constexpr int kMaxHalfs = 1000;

/// All rows, sorted by name as the server sends them.
const ParameterTable<ServerParams>& server_param_table();

}  // namespace cls::soccer
