// Checks of match options, all in one place.
#include "orchestration/match/options/match_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <variant>

#include "base/system/host.h"
#include "mock-server/mock.h"
#include "orchestration/match/lockstep_match.h"

namespace cls::orchestration::match {

using base::Error;
using base::Result;

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

soccer::ServerParams server_params(const MatchOptions& options) {
  soccer::ServerParams params = options.server;
  if (options.trainer && !params.coach) params.coach_w_referee = true;
  return params;
}

MatchMode mode_of(const MatchOptions& options) {
  if (options.mode) return *options.mode;
  const bool foreign = options.server_choice.kind != ServerChoice::Kind::kEmbedded ||
                       !options.left.has_playmaker() || !options.right.has_playmaker();
  return foreign ? MatchMode::kSynch : MatchMode::kLockstep;
}

std::optional<std::chrono::milliseconds> decision_deadline(const MatchOptions& options) {
  if (options.no_deadline) return std::nullopt;
  if (options.rpc_deadline_ms) return std::chrono::milliseconds(*options.rpc_deadline_ms);
  switch (mode_of(options)) {
    case MatchMode::kSynch:
      return std::chrono::milliseconds(1000);
    case MatchMode::kRealtime:
      return std::chrono::milliseconds(70);
    case MatchMode::kLockstep:
      break;
  }
  return std::chrono::milliseconds(10'000);
}

Result<void> pin_sides(MatchOptions& options) {
  auto [left, right] = base::halves_of(base::allowed_cores());
  if (left.empty()) return Error{"--pin: there is only one processor to use"};
  options.left_cpus = std::move(left);
  options.right_cpus = std::move(right);
  return {};
}

namespace {

using Demand = std::function<void(bool holds, std::string message)>;

template <typename Params>
bool same(const Params& one, const Params& other, const soccer::ParameterTable<Params>& table) {
  return std::all_of(table.begin(), table.end(), [&](const auto& row) {
    return std::visit([&](auto member) { return one.*member == other.*member; }, row.member);
  });
}

// Which server, which mode and which sides go together.
void check_server_and_mode(const MatchOptions& options, const Demand& demand) {
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  const bool lockstep = mode_of(options) == MatchMode::kLockstep;
  demand(lockstep || options.record_rpc.empty(), "--record-rpc needs --mode lockstep");
  demand(!lockstep || embedded, "--mode lockstep needs the embedded server: say synch or realtime");
  const bool there = options.server_choice.kind == ServerChoice::Kind::kAddress;
  const std::string& where = options.server_choice.text;
  const bool stock = same(options.server, match_server_params(), soccer::server_param_table()) &&
                     same(options.player, soccer::PlayerParams(), soccer::player_param_table());
  demand(!there || stock,
         fmt::format("the server at {} has settings of its own: no --set, no --half-time", where));
  for (const Endpoint* side : {&options.left, &options.right}) {
    demand(!lockstep || side->has_playmaker(),
           fmt::format("--mode lockstep has no place for side '{}': say synch or realtime",
                       side->text));
    demand(!there || side->has_playmaker(),
           fmt::format("side '{}' needs a server that cls starts: nobody at {} tells who joins",
                       side->text, where));
  }
}

}  // namespace

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
  demand(options.rpc_deadline_ms.value_or(1) > 0, "--rpc-deadline must be positive");
  check_server_and_mode(options, demand);
  demand(options.max_missed >= 0, "--max-missed must not be negative");
  demand(options.start_timeout_s > 0, "--start-timeout must be positive");
  demand(options.reconnect_within_s >= 0, "--reconnect-within must not be negative");
  demand(options.stall_after_s > 0, "--stall-after must be positive");
  demand(!options.time_limit_s || *options.time_limit_s > 0, "--time-limit must be positive");
  demand(!options.monitor_port || (*options.monitor_port >= 0 && *options.monitor_port <= 65535),
         "--monitor-port must be within 0..65535");
  demand(!options.speed || (*options.speed >= 0.1 && *options.speed <= 1000.0),
         "--speed must be within 0.1..1000");
  demand(mode_of(options) == MatchMode::kLockstep || (!options.monitor_port && !options.speed),
         "--monitor-port and --speed go with --mode lockstep only; elsewhere monitors attach where "
         "players do");
  demand(options.server.half_time > 0 || options.cycles,
         "without a time limit of halves (server::half_time) give --cycles");
  if (options.trainer) {
    demand(options.trainer->has_playmaker(),
           fmt::format("--trainer '{}': a foreign team brings its own", options.trainer->text));
  }
  std::vector<const Endpoint*> asked = {&options.left, &options.right};
  if (options.trainer) asked.push_back(&*options.trainer);
  for (const Endpoint* side : asked) {
    if (side->kind != Endpoint::Kind::kMock || side->script != nullptr) continue;
    if (mock_server::names_script(side->behaviour)) continue;
    const auto behaviour = mock_server::make_behaviour(side->behaviour);
    if (!behaviour) mistakes.push_back(behaviour.error().message);
  }
  const auto server = simulator::LockstepServer::create(server_config(options, 0));
  if (!server) mistakes.push_back(server.error().message);
  return mistakes;
}

}  // namespace cls::orchestration::match
