// The table of server:: parameters.
#include "soccer/parameters/server_params.h"

#include <algorithm>
#include <cmath>

namespace cls::soccer {
namespace {

// No half is longer, whatever a server sends: kMaxHalfs of them fit an int.
constexpr double kMaxHalf = 1 << 20;

int cycles_of(int seconds, const ServerParams& params) {
  // slow_down_factor makes steps longer, but halves have no fewer of them.
  const double cycles = std::floor(seconds * 1000.0 / params.simulator_step + 0.5);
  if (std::isnan(cycles)) return 0;
  return static_cast<int>(std::clamp(cycles, -kMaxHalf, kMaxHalf));
}

int limited(int halfs) { return std::clamp(halfs, -kMaxHalfs, kMaxHalfs); }

}  // namespace

int ServerParams::half_time_cycles() const { return cycles_of(half_time, *this); }
int ServerParams::extra_half_time_cycles() const { return cycles_of(extra_half_time, *this); }
int ServerParams::normal_time_cycles() const {
  return half_time_cycles() * limited(nr_normal_halfs);
}
int ServerParams::total_time_cycles() const {
  return normal_time_cycles() + extra_half_time_cycles() * limited(nr_extra_halfs);
}

const ParameterTable<ServerParams>& server_param_table() {
  static const ParameterTable<ServerParams> table = sorted_by_name(ParameterTable<ServerParams>{
#define CLS_SERVER_PARAM(type, name, value, since, unit, effect) \
  {#name, &ServerParams::name, since, unit, effect},
#include "soccer/parameters/server_params.inc"
#undef CLS_SERVER_PARAM
  });
  return table;
}

}  // namespace cls::soccer
