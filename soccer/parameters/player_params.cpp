// The table of player:: parameters.
#include "soccer/parameters/player_params.h"

namespace cls::soccer {

const ParameterTable<PlayerParams>& player_param_table() {
  static const ParameterTable<PlayerParams> table = sorted_by_name(ParameterTable<PlayerParams>{
#define CLS_PLAYER_PARAM(type, name, value, since, effect) \
  {#name, &PlayerParams::name, since, "", effect},
#include "soccer/parameters/player_params.inc"
#undef CLS_PLAYER_PARAM
  });
  return table;
}

}  // namespace cls::soccer
