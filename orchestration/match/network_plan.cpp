// What a match over UDP will start.
#include <fmt/format.h>

#include <filesystem>

#include "orchestration/match/network_match.h"

namespace cls::orchestration::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

constexpr int kPortsOfAServer = 3;
// Cycles after the end, for clients to notice; the stock 100 are 10 s in real time.
constexpr int kGameOverWait = 20;

Result<std::vector<std::string>> server_program(const MatchOptions& options, std::uint64_t seed,
                                                const fs::path& folder) {
  if (options.server_choice.kind == ServerChoice::Kind::kProgram) {
    const auto program = process::find_program(options.server_choice.program);
    if (program) return std::vector<std::string>{program->string()};
    return Error{fmt::format("soccer server {}", program.error().message)};
  }
  std::error_code code;
  const fs::path self = fs::read_symlink("/proc/self/exe", code);
  if (code) return Error{fmt::format("where this program is: {}", code.message())};
  std::vector<std::string> words = {self.string(),        "server", "--seed",
                                    std::to_string(seed), "--dir",  folder.string()};
  if (options.cycles) {
    words.push_back("--cycles");
    words.push_back(std::to_string(*options.cycles));
  }
  return words;
}

TeamValues team_values(const MatchOptions& options, const TeamNames& names, std::size_t side,
                       const NetworkPlan& plan, const fs::path& folder) {
  TeamValues values;
  values.host = plan.server_host;
  values.ports = plan.ports;
  values.side = side == 0 ? soccer::Side::kLeft : soccer::Side::kRight;
  values.team_name = side == 0 ? names.left : names.right;
  values.coach = options.coach;
  values.folder = folder;
  values.cpus = side == 0 ? options.left_cpus : options.right_cpus;
  return values;
}

Result<void> plan_teams(NetworkPlan& plan, const MatchOptions& options, const TeamNames& names,
                        const fs::path& folder) {
  for (std::size_t side = 0; side < 2; ++side) {
    const Endpoint& endpoint = side == 0 ? options.left : options.right;
    if (endpoint.kind != Endpoint::Kind::kTeam) continue;
    auto team = team_plan(endpoint.path, team_values(options, names, side, plan, folder));
    if (!team) return team.error();
    plan.teams[side] = std::move(*team);
  }
  return {};
}

bool needs_stock_ports(const NetworkPlan& plan) {
  for (const auto& team : plan.teams) {
    if (team && !team->takes_ports) return true;
  }
  return false;
}

}  // namespace

Result<NetworkPlan> plan_network_match(const MatchOptions& options, const TeamNames& names,
                                       std::uint64_t seed, const fs::path& folder) {
  NetworkPlan plan;
  if (options.server_choice.kind == ServerChoice::Kind::kAddress) {
    plan.server_host = options.server_choice.host;
    plan.ports = {options.server_choice.port, options.server_choice.port + 1,
                  options.server_choice.port + 2};
    if (const auto planned = plan_teams(plan, options, names, folder); !planned) {
      return planned.error();
    }
    return plan;
  }
  auto program = server_program(options, seed, folder);
  if (!program) return program.error();
  if (const auto planned = plan_teams(plan, options, names, folder); !planned) {
    return planned.error();
  }
  if (!needs_stock_ports(plan)) {
    auto ports = process::ReservedPort::choose(kPortsOfAServer);
    if (!ports) return ports.error();
    plan.reserved = std::move(*ports);
    plan.ports = {plan.reserved[0].number(), plan.reserved[1].number(), plan.reserved[2].number()};
    // The start scripts have to be told.
    if (const auto planned = plan_teams(plan, options, names, folder); !planned) {
      return planned.error();
    }
  }
  ServerSetup setup;
  setup.program = std::move(*program);
  setup.folder = folder;
  setup.ports = plan.ports;
  setup.mode = mode_of(options);
  setup.server = server_params(options);
  setup.player = options.player;
  if (setup.server.game_over_wait == soccer::ServerParams().game_over_wait) {
    setup.server.game_over_wait = kGameOverWait;
  }
  plan.server = server_plan(setup);
  return plan;
}

std::string taken_port(const NetworkPlan& plan) {
  if (!plan.server || !plan.reserved.empty()) return {};
  for (const int port : {plan.ports.player, plan.ports.trainer, plan.ports.coach}) {
    if (!process::port_is_free(process::Protocol::kUdp, port)) {
      return fmt::format("{}: a team whose start script knows no ports needs 6000 to 6002",
                         process::port_taken_text(process::Protocol::kUdp, port));
    }
  }
  return {};
}

}  // namespace cls::orchestration::match
