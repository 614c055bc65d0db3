// Settings by module and name.
#include "soccer/parameters/match_parameters.h"

#include <fmt/format.h>

#include "soccer/parameters/server_setting.h"

namespace cls::soccer {

using base::Error;
using base::Result;

ServerParams match_server_params() {
  ServerParams params;
  params.nr_extra_halfs = 0;
  params.penalty_shoot_outs = false;
  return params;
}

Result<void> apply_setting(ServerParams& server, PlayerParams& player, std::string_view setting) {
  const std::size_t colons = setting.find("::");
  const std::size_t equals = setting.find('=');
  if (colons == std::string_view::npos || equals == std::string_view::npos || equals < colons) {
    return Error{fmt::format("'{}' must be server::NAME=VALUE or player::NAME=VALUE", setting)};
  }

  const std::string_view module = setting.substr(0, colons);
  const std::string_view name = setting.substr(colons + 2, equals - colons - 2);
  const std::string_view value = setting.substr(equals + 1);
  if (module == "server") return set_server_parameter(server, name, value);
  if (module == "player") return set_parameter(player, player_param_table(), name, value);
  return Error{fmt::format("'{}': unknown module '{}'; must be server or player", setting, module)};
}

}  // namespace cls::soccer
