// Programs and ports of a match over UDP.
#include "match/server/match_plan.h"

#include <fmt/format.h>

#include "base/system/own_program.h"
#include "match/programs/team_sandbox.h"
#include "match/terms/server_settings.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;
using soccer::Side;

constexpr int kPortsOfServer = 3;
// Cycles after the end for clients to notice it; the default of 100 lasts 10 s in real time.
constexpr int kGameOverWait = 20;
// For --step: as long as a user may think about one cycle, 24 hours.
constexpr int kInteractiveWaitMs = 86'400'000;

Result<std::vector<std::string>> server_program(const MatchOptions& options, const TeamNames& names,
                                                std::uint64_t seed, const fs::path& folder) {
  if (options.server_choice.kind == ServerChoice::Kind::kProgram) {
    const auto program = process::find_program(options.server_choice.program);
    if (program) return std::vector<std::string>{program->string()};
    const bool is_known = options.server_choice.program == "rcssserver";
    return Error{fmt::format("soccer server {}{}", program.error().message,
                             is_known ? "; `cls doctor` says how to install it" : "")};
  }

  TRY_INIT(const fs::path self, base::own_program());
  std::vector<std::string> argv = {self.string(),        "server", "--seed",
                                   std::to_string(seed), "--dir",  folder.string()};
  if (options.cycles) argv.insert(argv.end(), {"--cycles", std::to_string(*options.cycles)});

  if (options.bind_clients) {
    BoundSides bound;
    int door = process::kFirstPassedFd;
    bound.trainer = options.trainer.has_value();
    for (const Side side : soccer::kBothSides) {
      const Endpoint& endpoint = endpoint_of(options, side);
      bound.external[side] = endpoint.kind == Endpoint::Kind::kTeam;
      if (bound.external[side] && !endpoint.parts.empty()) bound.names[side] = names[side];
      if (has_namespaces(options, side)) bound.doors[side] = door++;
    }
    argv.push_back(bound_sides_argument(bound));
  }
  if (options.step) argv.push_back(fmt::format("sync::max_wait_ms={}", kInteractiveWaitMs));
  return argv;
}

Result<void> plan_teams(MatchPlan& plan, const MatchOptions& options, const TeamNames& names,
                        const fs::path& folder) {
  for (const Side side : soccer::kBothSides) {
    const Endpoint& endpoint = endpoint_of(options, side);
    if (endpoint.kind != Endpoint::Kind::kTeam) continue;
    TRY_INIT(auto team, team_plan(endpoint, team_values(options, names, side, plan.server_host,
                                                        plan.ports, folder)));
    team.own_network = has_namespaces(options, side);
    plan.teams[side] = std::move(team);
  }
  return {};
}

bool needs_stock_ports(const MatchPlan& plan) {
  const auto needs = [](const std::optional<TeamPlan>& team) {
    return team && !team->own_network && !team->takes_ports;
  };
  return needs(plan.teams.left) || needs(plan.teams.right);
}

// The player port is the one that monitors were promised. Otherwise free ports, in a row because
// many teams take the next but one for the coach's; an external team may know the usual ones only.
Result<void> choose_ports(MatchPlan& plan, int monitor_port) {
  if (monitor_port != 0) {
    plan.ports = {monitor_port, monitor_port + 1, monitor_port + 2};
    return {};
  }
  const auto is_here = [](const std::optional<TeamPlan>& team) {
    return team && !team->own_network;
  };
  const bool external = is_here(plan.teams.left) || is_here(plan.teams.right);
  const int wish = external ? ServerPorts().player : 0;
  TRY_INIT(auto ports, process::ReservedPort::choose_row(kPortsOfServer, wish));
  plan.reserved = std::move(ports);
  plan.ports = {plan.reserved[0].number(), plan.reserved[1].number(), plan.reserved[2].number()};
  return {};
}

ServerSetup server_setup(const MatchOptions& options, const MatchPlan& plan,
                         std::vector<std::string> program, const fs::path& folder) {
  ServerSetup setup;
  setup.program = std::move(program);
  setup.folder = folder;
  setup.ports = plan.ports;
  setup.mode = mode_of(options);
  setup.server = server_params(options);
  setup.player = options.player;
  if (setup.server.game_over_wait == soccer::ServerParams().game_over_wait) {
    setup.server.game_over_wait = kGameOverWait;
  }
  return setup;
}

}  // namespace

TeamValues team_values(const MatchOptions& options, const TeamNames& names, Side side,
                       const std::string& host, const ServerPorts& ports, const fs::path& folder) {
  TeamValues values;
  values.namespaces = has_namespaces(options, side);
  values.host = values.namespaces ? kLoopback : host;
  values.ports = values.namespaces ? ServerPorts() : ports;
  values.side = side;
  values.team_name = names[side];
  values.coach = options.coach;
  values.folder = folder;
  values.cpus = options.cpus[side];
  values.limits = options.limits;
  values.sandbox = options.sandbox != Sandbox::kOff;
  values.hidden = team_folders(endpoint_of(options, soccer::opponent(side)));
  return values;
}

Result<MatchPlan> plan_match(const MatchOptions& options, const TeamNames& names,
                             std::uint64_t seed, const fs::path& folder) {
  MatchPlan plan;
  const ServerChoice& server = options.server_choice;
  if (server.kind == ServerChoice::Kind::kAddress) {
    plan.server_host = server.host;
    plan.ports = {server.port, server.port + 1, server.port + 2};
    TRY(plan_teams(plan, options, names, folder));
    return plan;
  }

  TRY_INIT(auto program, server_program(options, names, seed, folder));
  TRY(plan_teams(plan, options, names, folder));
  const int monitor_port = options.monitor_port.value_or(0);
  if (!needs_stock_ports(plan)) {
    TRY(choose_ports(plan, monitor_port));
    // Once more, because the start scripts get the ports as arguments.
    TRY(plan_teams(plan, options, names, folder));
  } else if (monitor_port != 0 && monitor_port != plan.ports.player) {
    return Error{
        fmt::format("--monitor-port {}: a team whose start script takes no ports needs the "
                    "server at {}",
                    monitor_port, plan.ports.player)};
  }

  plan.server = server_plan(server_setup(options, plan, std::move(program), folder));
  return plan;
}

std::string port_in_use(const MatchPlan& plan) {
  if (!plan.server || !plan.reserved.empty()) return {};

  const std::string taken = process::taken_port(
      process::Protocol::kUdp, {plan.ports.player, plan.ports.trainer, plan.ports.coach});
  const bool stock = needs_stock_ports(plan);
  return taken + (stock && !taken.empty()
                      ? ": a team whose start script takes no ports needs 6000 to 6002"
                      : "");
}

}  // namespace cls::match
