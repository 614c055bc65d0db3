// Checks of match options, all in one place.
#include "orchestration/match_options.h"

#include <fmt/format.h>

#include "mock-server/mock.h"
#include "orchestration/lockstep_match.h"

namespace cls::orchestration {

using soccer::Error;
using soccer::Result;

soccer::ServerParams match_server_params() {
  soccer::ServerParams params;
  params.nr_extra_halfs = 0;
  params.penalty_shoot_outs = false;
  return params;
}

Result<void> apply_setting(MatchOptions& options, std::string_view setting) {
  const std::size_t colons = setting.find("::");
  const std::size_t equals = setting.find('=');
  if (colons == std::string_view::npos || equals == std::string_view::npos || equals < colons) {
    return Error{fmt::format("'{}' is not of the form server::NAME=VALUE", setting)};
  }
  const std::string_view module = setting.substr(0, colons);
  const std::string_view name = setting.substr(colons + 2, equals - colons - 2);
  const std::string_view value = setting.substr(equals + 1);
  if (module == "server") {
    return set_parameter(options.server, soccer::server_param_table(), name, value);
  }
  if (module == "player") {
    return set_parameter(options.player, soccer::player_param_table(), name, value);
  }
  return Error{fmt::format("'{}': the module is server or player, not '{}'", setting, module)};
}

std::vector<std::string> mistakes_in(const MatchOptions& options) {
  std::vector<std::string> mistakes;
  const auto demand = [&mistakes](bool holds, std::string message) {
    if (!holds) mistakes.push_back(std::move(message));
  };
  for (const std::string* name : {&options.left_name, &options.right_name}) {
    if (name->empty()) continue;
    const auto checked = check_team_name(*name);
    if (!checked) mistakes.push_back(checked.error().message);
  }
  demand(options.protocol >= 14 && options.protocol <= 19,
         fmt::format("--protocol {}: agents speak versions 14 to 19", options.protocol));
  demand(!options.cycles || *options.cycles > 0, "--cycles must be positive");
  demand(options.rpc_deadline_ms > 0, "--rpc-deadline must be positive");
  demand(options.max_missed >= 0, "--max-missed must not be negative");
  demand(options.start_timeout_s > 0, "--start-timeout must be positive");
  demand(options.stall_after_s > 0, "--stall-after must be positive");
  demand(!options.time_limit_s || *options.time_limit_s > 0, "--time-limit must be positive");
  demand(options.server.half_time > 0 || options.cycles,
         "without a time limit of halves (server::half_time) give --cycles");
  for (const Endpoint* side : {&options.left, &options.right}) {
    if (side->kind != Endpoint::Kind::kMock || side->script != nullptr) continue;
    if (mock_server::names_script(side->behaviour)) continue;
    const auto behaviour = mock_server::make_behaviour(side->behaviour);
    if (!behaviour) mistakes.push_back(behaviour.error().message);
  }
  const auto server = simulator::LockstepServer::create(server_config(options, 0));
  if (!server) mistakes.push_back(server.error().message);
  return mistakes;
}

}  // namespace cls::orchestration
