// The player:: parameters of rcssserver: heterogeneous types and substitutions.
#pragma once

#include "soccer/parameters/parameter.h"

namespace cls::soccer {

/// Every player:: parameter of rcssserver 19 with its default (docs/spec/server-protocol.md 10.4).
struct PlayerParams {
#define CLS_PLAYER_PARAM(type, name, value, since, effect) type name = value;
#include "soccer/parameters/player_params.inc"
#undef CLS_PLAYER_PARAM
};

/// All rows, sorted by name as the server sends them.
const ParameterTable<PlayerParams>& player_param_table();

}  // namespace cls::soccer
