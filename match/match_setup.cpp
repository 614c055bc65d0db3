// One constructor of sides for each kind of server.
#include "match/match_setup.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "match/live_loop.h"
#include "match/lockstep_loop.h"
#include "match/programs/team_sandbox.h"
#include "match/saved/saved_match.h"
#include "match/sides/external_side.h"
#include "match/sides/lockstep_agents.h"
#include "match/sides/network_agents.h"
#include "match/sides/side_sandbox.h"
#include "process/namespaces.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using base::Result;
using soccer::Side;
using TeamPlans = soccer::PerSide<std::optional<TeamPlan>>;

std::vector<Side> sides_of(const MatchOptions& options) {
  std::vector<Side> sides = {Side::kLeft, Side::kRight};
  if (options.trainer) sides.push_back(Side::kNeutral);
  return sides;
}

// A Playmaker that leaves RegisterTeam unanswered is asked for each agent in the rest of the start
// limit. A program in its first seconds, on a busy host, needs more than a fixed short time.
proxy::RpcTimeout team_reply_timeout(const MatchOptions& options) {
  constexpr double kShare = 0.5;
  if (options.batch != proxy::BatchMode::kAuto) return proxy::kNoTimeout;
  return proxy::RpcTimeout(static_cast<int>(kShare * options.start_timeout_s * 1000.0));
}

SideSetup side_setup(const MatchSetup& setup, Side side) {
  const bool trainer = side == Side::kNeutral;
  SideSetup result;
  result.side = side;
  result.name = trainer ? setup.names.left : setup.names[side];
  result.seed = setup.seed;
  result.folder = setup.folder;
  result.host = setup.host;
  result.batch = setup.options.batch;
  result.team_reply = team_reply_timeout(setup.options);
  result.limits = setup.options.limits;
  if (!trainer) result.cpus = setup.options.cpus[side];
  return result;
}

SideIdentity identity_of(const MatchSetup& setup, Side side) {
  return {side, side == Side::kNeutral ? "trainer" : side_setup(setup, side).name,
          endpoint_of(setup.options, side).text};
}

using SideNamespaces = soccer::PerSide<std::shared_ptr<const process::Namespaces>>;

// Of the sides whose programs start in namespaces.
Result<SideNamespaces> make_namespaces(const MatchOptions& options) {
  SideNamespaces made;
  for (const Side side : soccer::kBothSides) {
    if (!has_namespaces(options, side)) continue;
    auto namespaces = process::Namespaces::create();
    if (!namespaces) {
      return base::Error{fmt::format("namespaces for the {} side: {}", side_name(side),
                                     namespaces.error().message)};
    }
    made[side] = *std::move(namespaces);
  }
  return made;
}

// Plans of the external teams, with the port that the server has opened for them.
Result<TeamPlans> plan_external_teams(const MatchSetup& setup, const SideNamespaces& namespaces,
                                      EmbeddedServer& server) {
  TeamPlans plans;
  bool takes_ports = true;
  ServerPorts ports;
  // The first round shows whether the start scripts take ports, the second one uses them.
  for (const bool opened : {false, true}) {
    for (const Side side : soccer::kBothSides) {
      const Endpoint& endpoint = endpoint_of(setup.options, side);
      if (endpoint.kind != Endpoint::Kind::kTeam) continue;

      TeamValues values =
          team_values(setup.options, setup.names, side, kLoopback, ports, setup.folder);
      values.coach = false;
      TRY_INIT(auto plan, team_plan(endpoint, values));
      takes_ports = takes_ports && plan.takes_ports;
      plans[side] = std::move(plan);
      server.expect_external_team(side, endpoint.parts.empty() ? "" : values.team_name);
    }

    if (opened || (!plans.left && !plans.right)) break;
    bool here = false;
    for (const Side side : soccer::kBothSides) {
      if (namespaces[side] != nullptr) TRY(server.open_player_port_in(namespaces[side], side));
      here = here || (plans[side] && namespaces[side] == nullptr);
    }
    if (!here) break;
    TRY_INIT(const auto chosen, server.open_player_port(takes_ports));
    ports = chosen;
  }
  return plans;
}

ExternalSide::OnOtherName on_other_name(const MatchOptions& options, Side side) {
  return options.names[side].empty() || options.own_names ? ExternalSide::OnOtherName::kWarn
                                                          : ExternalSide::OnOtherName::kRefuse;
}

NetworkSettings network_settings(const MatchSetup& setup, const MatchPlan& plan, Side side) {
  const MatchOptions& options = setup.options;
  NetworkSettings settings;
  settings.server_host = plan.server_host;
  settings.server_port = plan.ports.player;
  if (side == Side::kNeutral) {
    settings.trainer_port = plan.ports.trainer;
    return settings;
  }

  if (options.coach) settings.coach_port = plan.ports.coach;
  // The embedded server has a cycle limit of its own.
  if (options.server_choice.kind != ServerChoice::Kind::kEmbedded) {
    settings.cycle_limit = options.cycles;
  }
  settings.hold_turns = options.step;
  settings.speed = options.speed;
  return settings;
}

// The sides of a match: external teams on `server`, and those whose agents `agents_of` makes.
template <class OnOtherNameOf, class AgentsOf>
Result<Sides> make_sides(const MatchSetup& setup, TeamPlans teams, const SideNamespaces& namespaces,
                         Server& server, const OnOtherNameOf& on_other_name_of,
                         const AgentsOf& agents_of) {
  Sides sides;
  for (const Side side : sides_of(setup.options)) {
    if (side != Side::kNeutral && teams[side]) {
      sides.push_back(std::make_unique<ExternalSide>(
          identity_of(setup, side), *std::move(teams[side]), on_other_name_of(setup.options, side),
          server, *setup.host, setup.options.side_limits, namespaces[side]));
      continue;
    }

    SideSetup values = side_setup(setup, side);
    const Endpoint& endpoint = endpoint_of(setup.options, side);
    TRY_INIT(values.sandbox, PlaymakerSandbox::create(setup.options, side, setup.folder));
    TRY_INIT(auto connection, connect_playmaker(endpoint, values));
    TRY_INIT(auto agents,
             agents_of(side, AgentParts{identity_of(setup, side), std::move(connection),
                                        team_options(values, endpoint, setup.options),
                                        setup.options, values.cpus, values.sandbox}));
    sides.push_back(std::move(agents));
  }
  return sides;
}

// Of the sides that have a network of their own, on a server that has no ports in it.
Result<void> open_relays(const MatchSetup& setup, const SideNamespaces& namespaces,
                         ExternalServer& server) {
  for (const Side side : soccer::kBothSides) {
    if (endpoint_of(setup.options, side).kind != Endpoint::Kind::kTeam) {
      server.reserve_name(side, setup.names[side]);
    }
    if (namespaces[side] == nullptr) continue;
    if (auto opened = server.open_relay(side, namespaces[side]); !opened) {
      return base::Error{
          fmt::format("relay for the {} side: {}", side_name(side), opened.error().message)};
    }
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<Match>> make_lockstep_match(const MatchSetup& setup,
                                                   const LockstepLogs& logs) {
  const MatchOptions& options = setup.options;
  TRY_INIT(auto server, EmbeddedServer::create(options, setup.seed));
  EmbeddedServer& embedded = *server;
  embedded.record(logs.game_log, logs.text_log, logs.events);
  if (options.resumed != nullptr && options.branch_seed) {
    embedded.branch(options.resumed->steps(), *options.branch_seed);
  }

  TRY_INIT(const auto namespaces, make_namespaces(options));
  TRY_INIT(auto teams, plan_external_teams(setup, namespaces, embedded));
  bool match_thread_taken = false;
  const auto agents_of = [&](Side side, AgentParts parts) -> Result<std::unique_ptr<MatchSide>> {
    PlaymakerConnection& connection = parts.connection;
    if (options.resumed != nullptr) {
      connection.playmaker =
          proxy::resume_with(std::move(connection.playmaker), replies_of(*options.resumed, side));
    }

    const bool on_match_thread =
        connection.direct && parts.cpus.empty() && !std::exchange(match_thread_taken, true);
    auto agents = std::make_unique<LockstepAgents>(std::move(parts), embedded);
    if (on_match_thread) agents->take_turns_on_match_thread();
    return std::unique_ptr<MatchSide>(std::move(agents));
  };
  const auto accept = [](const MatchOptions&, Side) { return ExternalSide::OnOtherName::kAccept; };
  TRY_INIT(auto sides,
           make_sides(setup, std::move(teams), namespaces, embedded, accept, agents_of));

  const auto loop = [&](const Sides& all, MatchGuard& guard) {
    return std::make_unique<LockstepLoop>(options, embedded, all, guard);
  };
  return std::make_unique<Match>(options, std::move(server), std::move(sides), loop, setup.seed,
                                 setup.stop_signal);
}

Result<std::unique_ptr<Match>> make_external_match(const MatchSetup& setup, MatchPlan plan) {
  const MatchOptions& options = setup.options;
  auto teams = std::exchange(plan.teams, {});
  std::map<Side, NetworkSettings> network;
  for (const Side side : sides_of(options)) network[side] = network_settings(setup, plan, side);
  TRY_INIT(const auto namespaces, make_namespaces(options));
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  for (const Side side : soccer::kBothSides) {
    if (embedded && plan.server && has_namespaces(options, side)) {
      plan.server->passed.push_back(namespaces[side]->door().fd());
    }
  }
  auto server =
      std::make_unique<ExternalServer>(options, std::move(plan), setup.host, setup.folder);
  ExternalServer& external = *server;
  if (!embedded) TRY(open_relays(setup, namespaces, external));

  const auto agents_of = [&](Side side, AgentParts parts) -> Result<std::unique_ptr<MatchSide>> {
    TRY_INIT(auto agents, NetworkAgents::create(std::move(parts), network[side]));
    return std::unique_ptr<MatchSide>(std::move(agents));
  };
  TRY_INIT(auto sides,
           make_sides(setup, std::move(teams), namespaces, external, on_other_name, agents_of));

  const auto loop = [&](const Sides& all, MatchGuard& guard) {
    return std::make_unique<LiveLoop>(options, external, all, guard);
  };
  return std::make_unique<Match>(options, std::move(server), std::move(sides), loop, setup.seed,
                                 setup.stop_signal);
}

}  // namespace cls::match
