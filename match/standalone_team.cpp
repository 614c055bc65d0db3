// A match of one side on a server that runs already.
#include "match/standalone_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/text/json.h"
#include "base/text/json_text.h"
#include "match/hooks/debug_clients.h"
#include "match/live_loop.h"
#include "match/match.h"
#include "match/server/external_server.h"
#include "match/sides/network_agents.h"
#include "proxy/connection/offline_log.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "proxy/playmaker/thrift_playmaker.h"

namespace cls::match {
namespace {

constexpr int kRightPortOffset = 20;

// No limits but the start limit: the team plays as long as the server does.
MatchOptions match_options(const StandaloneTeamOptions& options) {
  MatchOptions match;
  match.left.kind = Endpoint::Kind::kAddress;
  match.server_choice.kind = ServerChoice::Kind::kAddress;
  match.server_choice.host = options.server_host;
  match.server_choice.port = options.server_port;
  match.start_timeout_s = options.start_timeout_s;
  match.stall_after_s = std::numeric_limits<double>::infinity();
  match.max_missed = std::numeric_limits<int>::max();
  return match;
}

// The number that the first agent of the team has towards its Playmaker.
int first_number(const StandaloneTeamOptions& options) {
  return options.team.players == 0 ? proxy::kCoachNumber : options.team.first_unum;
}

// Proxies of single agents share a Playmaker, which would take each of them for a whole team.
proxy::BatchMode batch_mode(const StandaloneTeamOptions& options) {
  if (options.playmaker.port_step || options.thrift) return proxy::BatchMode::kOff;
  const int agents = options.team.players + (options.coach_port != 0 ? 1 : 0) +
                     (options.trainer_port != 0 ? 1 : 0);
  const bool alone = options.batch == proxy::BatchMode::kAuto && agents == 1;
  return alone ? proxy::BatchMode::kOff : options.batch;
}

std::unique_ptr<proxy::Playmaker> make_playmaker(const proxy::GrpcTarget& target, bool thrift,
                                                 proxy::BatchMode batch) {
  if (thrift) return proxy::make_thrift_playmaker(target);
  return proxy::make_batch_playmaker(proxy::make_grpc_playmaker(target), batch);
}

base::Result<std::unique_ptr<NetworkAgents>> make_agents(const StandaloneTeamOptions& options,
                                                         const MatchOptions& match,
                                                         proxy::OfflineLogs* offline) {
  const proxy::BatchMode batch = batch_mode(options);
  NetworkSettings settings;
  settings.server_host = options.server_host;
  settings.server_port = options.server_port;
  settings.coach_port = options.coach_port;
  settings.trainer_port = options.trainer_port;
  settings.leave_at_time_over = false;
  settings.on_ready = options.on_ready;

  if (offline != nullptr) {
    const int first = options.team.reconnect ? options.team.first_unum : 0;
    settings.wrap = [offline, unum = first](std::unique_ptr<soccer::Channel> channel) mutable {
      return offline->record(std::move(channel), unum == 0 ? 0 : unum++);
    };
  }
  if (options.add_20_for_right) {
    settings.right_playmaker = [target = options.playmaker, thrift = options.thrift,
                                batch]() mutable {
      target.port += kRightPortOffset;
      return make_playmaker(target, thrift, batch);
    };
  }

  PlaymakerConnection connection;
  connection.playmaker = make_playmaker(options.playmaker, options.thrift, batch);
  const SideIdentity identity = {soccer::Side::kLeft, std::string(options.team.name.view()),
                                 address(options.playmaker, first_number(options))};
  return NetworkAgents::create({identity, std::move(connection), options.team, match},
                               std::move(settings));
}

void add_statistics(StandaloneTeamResult& result, PlayerResult player,
                    const player::GameState& game) {
  result.players.push_back(std::move(player));
  result.cycles = std::max(result.cycles, game.time.cycle);
  result.our_score = game.our_score;
  result.their_score = game.their_score;
}

void add_statistics(StandaloneTeamResult& result, const proxy::Team& team) {
  result.right_side = team.side() == soccer::Side::kRight;
  if (const proxy::CoachAgent* coach = team.coach()) {
    PlayerResult statistics = result_of(coach->number(), coach->statistics());
    statistics.commands = coach->commands();
    add_statistics(result, std::move(statistics), coach->world().game);
  }
  for (const auto& player : team.players()) {
    add_statistics(result, result_of(player->unum(), player->statistics()), player->world().game);
  }
}

}  // namespace

std::string to_json(const StandaloneTeamOptions& options, const StandaloneTeamResult& result) {
  using base::Json;
  const Json document = {{"schema", "cls.proxy/1"},
                         {"team", options.team.name.view()},
                         {"side", result.right_side ? "right" : "left"},
                         {"playmaker", address(options.playmaker, 0)},
                         {"end_reason", name(result.end_reason)},
                         {"message", result.message.empty() ? Json(nullptr) : Json(result.message)},
                         {"our_score", result.our_score},
                         {"their_score", result.their_score},
                         {"cycles", result.cycles},
                         {"players", Json::parse(to_json(result.players))},
                         {"errors", Json::parse(to_json(result.errors))}};
  return base::json_document(document);
}

StandaloneTeamResult run_standalone_team(const StandaloneTeamOptions& options,
                                         MatchObserver& observer,
                                         const std::atomic<int>& stop_signal) {
  StandaloneTeamResult result;
  const MatchOptions match_options = match::match_options(options);
  proxy::OfflineLogs offline(options.offline_log, std::string(options.team.name.view()));
  auto agents =
      make_agents(options, match_options, options.offline_log.empty() ? nullptr : &offline);
  if (!agents) {
    result.end_reason = EndReason::kRefused;
    result.message = agents.error().message;
    return result;
  }

  const NetworkAgents& team = **agents;
  Sides sides;
  sides.push_back(*std::move(agents));
  MatchPlan plan;
  plan.server_host = options.server_host;
  plan.ports.player = options.server_port;
  auto server = std::make_unique<ExternalServer>(match_options, std::move(plan), nullptr,
                                                 std::filesystem::path());
  const auto loop = [&match_options, &external = *server](const Sides& all, MatchGuard& guard) {
    return std::make_unique<LiveLoop>(match_options, external, all, guard);
  };
  Match match(match_options, std::move(server), std::move(sides), loop, 0, stop_signal);

  DebugClients debug(options.debug);
  if (options.debug.wanted()) match.add_hooks(debug);
  match.play(observer);
  result.write_error = debug.close();
  if (std::string error = offline.close(); result.write_error.empty()) {
    result.write_error = std::move(error);
  }

  result.end_reason = match.result().end_reason;
  result.message = match.result().message;
  result.signal = match.result().signal;
  result.errors = match.result().left.errors;
  add_statistics(result, team.team());
  return result;
}

}  // namespace cls::match
