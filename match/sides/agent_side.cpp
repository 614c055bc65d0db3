// Setting up a cls team, and reading off what it did.
#include "match/sides/agent_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/index.h"
#include "match/result/match_end.h"
#include "match/sides/policy_rows.h"
#include "match/sides/side_sandbox.h"
#include "proxy/playmaker/batch_playmaker.h"
#include "proxy/playmaker/direct_playmaker.h"
#include "proxy/playmaker/grpc_playmaker.h"
#include "proxy/playmaker/mixed_playmaker.h"
#include "training/policy/policy_player.h"

namespace cls::match {
namespace {

using base::Result;

proxy::RpcTimeout to_timeout(double seconds) {
  return std::chrono::duration_cast<proxy::RpcTimeout>(std::chrono::duration<double>(seconds));
}

std::map<std::string, std::int64_t> missed_by(const proxy::AgentStatistics& statistics) {
  std::map<std::string, std::int64_t> by_outcome;
  for (int i = 1; i < proxy::kRpcOutcomes; ++i) {
    const std::int64_t n = statistics.outcomes[base::index(i)];
    const auto outcome = static_cast<proxy::RpcOutcome>(i);
    if (n != 0 && outcome != proxy::RpcOutcome::kCancelled) by_outcome.emplace(name(outcome), n);
  }
  return by_outcome;
}

RpcLatency latency_of(const proxy::LatencySamples& samples) {
  return {samples.percentile(0.50), samples.percentile(0.95), samples.percentile(0.99),
          samples.max()};
}

/// Starts the mock and connects to it. Without faults no reply is late or fails, so `auto` calls
/// the mock as a function; other modes of --batch ask for a way of gRPC.
Result<void> connect_mock(const Endpoint& endpoint, const SideSetup& setup,
                          PlaymakerConnection& out) {
  TRY_INIT(auto started, start_mock(endpoint));
  out.mock = std::move(started);
  mock_server::Server& mock = *out.mock;
  out.direct = setup.batch == proxy::BatchMode::kAuto && mock.faultless();
  if (out.direct) {
    out.playmaker = proxy::make_direct_playmaker(
        [&mock](proto::Rpc rpc, const google::protobuf::Message& request,
                google::protobuf::Message& reply) { mock.handle(rpc, request, reply); });
  } else {
    out.playmaker = proxy::make_grpc_playmaker(mock.in_process_channel(), endpoint.text);
  }
  return {};
}

/// Connects the parts, and has each agent's calls go to its own.
Result<PlaymakerConnection> connect_parts(const Endpoint& endpoint, const SideSetup& setup) {
  PlaymakerConnection connection;
  connection.endpoint = endpoint;
  std::vector<std::unique_ptr<proxy::Playmaker>> playmakers;
  proxy::PartOfAgent part_of{};
  for (const Endpoint& part : endpoint.parts) {
    auto connected = connect_playmaker(part, setup);
    if (!connected) return connected;

    for (const int agent : part.agents) part_of.at(base::index(agent)) = playmakers.size();
    playmakers.push_back(std::move(connected->playmaker));
    connection.parts.push_back(*std::move(connected));
  }
  connection.playmaker = proxy::make_mixed_playmaker(std::move(playmakers), part_of);
  return connection;
}

double cpu_seconds_of_mock(const PlaymakerConnection& connection) {
  constexpr double kNanosecond = 1e-9;
  // The decisions of a direct mock count as work of the side's thread.
  if (connection.mock == nullptr || connection.direct) return 0.0;
  return static_cast<double>(connection.mock->decision_nanoseconds()) * kNanosecond;
}

double cpu_seconds(const PlaymakerConnection& connection) {
  const double program =
      connection.process == nullptr ? 0.0 : connection.process->child().cpu_seconds();
  return program + cpu_seconds_of_mock(connection);
}

}  // namespace

proxy::TeamOptions team_options(const SideSetup& setup, const Endpoint& endpoint,
                                const MatchOptions& options) {
  proxy::TeamOptions team;
  team.name = soccer::TeamName(setup.name);
  if (setup.side == soccer::Side::kNeutral) {
    team.players = 0;
  } else {
    team.formations = options.formations[setup.side];
  }

  team.planner = endpoint.planner;
  if (endpoint.policy != nullptr) {
    team.make_own_play = [policy = endpoint.policy]() -> proxy::OwnPlay {
      const auto player = std::make_shared<training::PolicyPlayer>(policy);
      return [player](player::ActionContext& context) { player->play(context); };
    };
  }
  team.protocol = options.protocol;
  team.on_late = options.on_late;
  team.decision_timeout = reply_timeout(options).value_or(proxy::kNoTimeout);
  team.start_timeout = to_timeout(options.start_timeout_s) + kMatchLimitMargin;
  team.reconnect_within = to_timeout(options.reconnect_within_s);

  team.codec = make_policy_rows();
  team.rated = options.rated;
  team.shared_playmaker = !endpoint.port_step && endpoint.kind != Endpoint::Kind::kMixed;
  return team;
}

PlayerResult result_of(int number, const proxy::AgentStatistics& statistics) {
  PlayerResult result;
  result.unum = number;
  result.decisions = statistics.decisions;
  result.late = statistics.late;
  result.missed = statistics.missed;
  result.undecided = statistics.undecided;
  result.lost_commands = statistics.lost_commands;
  result.late_wakeups = statistics.late_wakeups;
  result.rpc_us = latency_of(statistics.rpc_us);

  result.commands = statistics.commands_by_name();
  result.unimplemented_actions = statistics.unimplemented_by_name();
  result.actions = proxy::outcomes_by_name(statistics.actions);
  result.automatic = proxy::automatic_by_name(statistics.actions);
  result.lists = statistics.actions.lists;
  result.empty = statistics.actions.empty;
  result.useless = statistics.actions.useless;
  result.missed_by = missed_by(statistics);
  result.reconnects = statistics.reconnects;
  return result;
}

Result<PlaymakerConnection> connect_playmaker(const Endpoint& endpoint, const SideSetup& setup) {
  if (endpoint.kind == Endpoint::Kind::kMixed) return connect_parts(endpoint, setup);

  PlaymakerConnection connection;
  connection.endpoint = endpoint;
  if (endpoint.kind == Endpoint::Kind::kMock) {
    TRY(connect_mock(endpoint, setup, connection));
  } else if (endpoint.kind == Endpoint::Kind::kRun) {
    TRY_INIT(auto started,
             PlaymakerProcess::start(*setup.host, endpoint,
                                     {0, setup.side, setup.name, setup.seed, endpoint.label},
                                     setup.folder, setup.cpus, setup.limits, setup.sandbox.get()));
    connection.process = std::move(started);
    connection.playmaker =
        proxy::make_grpc_playmaker(connection.process->target(), setup.team_reply);
  } else {
    connection.playmaker = proxy::make_grpc_playmaker(target_of(endpoint), setup.team_reply);
  }

  if (!endpoint.port_step && !connection.direct) {
    connection.playmaker =
        proxy::make_batch_playmaker(std::move(connection.playmaker), setup.batch);
  }
  return connection;
}

AgentSide::AgentSide(AgentParts parts)
    : MatchSide(std::move(parts.identity)),
      sandbox_(std::move(parts.sandbox)),
      connection_(std::move(parts.connection)),
      options_(parts.options) {
  worker_.set_affinity(parts.cpus);
  watched_ = proxy::watch_calls(*connection_.playmaker, watch_);
  team_ = std::make_unique<proxy::Team>(std::move(parts.team), *watched_);
}

bool AgentSide::listen(SideListener& listener) {
  proxy::Playmaker& inner = listened_.empty() ? *watched_ : *listened_.back();
  if (proxy::DecisionListener* decisions = listener.decisions()) {
    team_->listen_to_decisions(*decisions);
  }
  listeners_.push_back(&listener);
  if (!listener.needs_calls()) return true;
  listened_.push_back(proxy::listen_to(inner, listener));
  team_->set_playmaker(*listened_.back());
  return true;
}

void AgentSide::begin_listening(int cycle) {
  for (SideListener* listener : listeners_) listener->begin_cycle(cycle);
}

void AgentSide::end_listening() {
  for (SideListener* listener : listeners_) listener->end_cycle();
}

void AgentSide::replace_playmaker(std::unique_ptr<proxy::Playmaker> playmaker) {
  watched_ = proxy::watch_calls(*playmaker, watch_);
  connection_.playmaker = std::move(playmaker);
  team_->set_playmaker(*watched_);
}

std::string AgentSide::no_answer() const {
  const auto call = awaited_reply();
  return who() + ": no answer" + (call ? " to " + describe(*call) : "");
}

std::optional<MatchEnd> AgentSide::shake_hands() {
  const proxy::RpcStatus status = team_->register_agents();
  if (status.ok()) return std::nullopt;
  const bool garbled = status.outcome == proxy::RpcOutcome::kProtocolError;
  return MatchEnd{.reason = garbled ? EndReason::kProtocolError : EndReason::kRefused,
                  .message = fmt::format("{}: {}", who(), status.message)};
}

std::vector<const PlaymakerConnection*> AgentSide::connections() const {
  if (connection_.parts.empty()) return {&connection_};
  std::vector<const PlaymakerConnection*> parts;
  for (const PlaymakerConnection& part : connection_.parts) parts.push_back(&part);
  return parts;
}

std::vector<const PlaymakerProcess*> AgentSide::playmaker_processes() const {
  std::vector<const PlaymakerProcess*> processes;
  for (const PlaymakerConnection* connection : connections()) {
    if (connection->process != nullptr) processes.push_back(connection->process.get());
  }
  return processes;
}

const PlaymakerConnection* AgentSide::awaited_connection() const {
  if (connection_.parts.empty()) return &connection_;
  const auto call = awaited_reply();
  for (const PlaymakerConnection& part : connection_.parts) {
    const std::vector<int>& agents = part.endpoint.agents;
    if (call && std::ranges::find(agents, call->agent) != agents.end()) return &part;
  }
  return nullptr;
}

std::string AgentSide::timeout_hint() const {
  const PlaymakerConnection* awaited = awaited_connection();
  if (awaited == nullptr) return {};
  return awaited->process != nullptr ? awaited->process->port_hint()
                                     : unreachable_hint(awaited->endpoint);
}

const process::Child* AgentSide::awaited_process() const {
  const PlaymakerConnection* awaited = awaited_connection();
  return awaited == nullptr || awaited->process == nullptr ? nullptr : &awaited->process->child();
}

std::optional<MatchEnd> AgentSide::failure(const MatchMoment& moment) {
  auto end = agent_failure(moment);
  for (const PlaymakerProcess* started : playmaker_processes()) {
    if (end) started->child().wait_exit(kProgramExitDelay);
    if (!started->ended()) continue;

    MatchEnd crash;
    crash.failure = failure_of(started->child());
    crash.reason = moment.playing ? EndReason::kCrashed : EndReason::kRefused;
    crash.message = fmt::format(
        "{}: its process ended {}: {}{}{}", who(),
        moment.playing ? fmt::format("at cycle {}", moment.cycle) : "before it answered",
        crash.failure->exit, limit_hint(started->child()),
        moment.playing ? std::string()
                       : sandbox_hint(started->child(), "play without --sandbox-playmakers"));
    return crash;
  }

  // Any program of a mixed side may be at fault.
  if (end && connection_.process != nullptr) {
    end->failure = failure_of(connection_.process->child());
  } else if (end) {
    end->failure = playmaker_failure(identity().side);
  }
  return end;
}

std::string AgentSide::excess(bool at_once) {
  return sandbox_ == nullptr ? std::string() : sandbox_->excess(at_once);
}

std::vector<ProcessResult> AgentSide::wait_gone() {
  std::vector<ProcessResult> results;
  for (const PlaymakerProcess* started : playmaker_processes()) {
    started->child().wait_gone(kTerminateGrace + kKillMargin);
    results.push_back(match::result_of(started->child()));
  }
  return results;
}

std::vector<std::string> AgentSide::failed_expectations() const {
  std::vector<std::string> all;
  for (const PlaymakerConnection* connection : connections()) {
    if (connection->mock == nullptr) continue;
    for (std::string& one : connection->mock->failed_expectations()) all.push_back(std::move(one));
  }
  return all;
}

double AgentSide::mock_cpu_seconds() const {
  double sum = 0.0;
  for (const PlaymakerConnection* connection : connections()) {
    sum += cpu_seconds_of_mock(*connection);
  }
  return sum;
}

// In a turn the agents compute, or wait for replies.
TurnTimes AgentSide::turn_times() const {
  const proxy::TeamTimes& times = team_->times();
  const auto work = times.perceive + times.state + times.begin + times.act;
  return {times.turns, std::max(std::chrono::nanoseconds(0), times.turns - work)};
}

// Latencies of several players are those of all their decisions.
void AgentSide::add_parts(TeamResult& result) const {
  for (const PlaymakerConnection& connection : connection_.parts) {
    PartResult part;
    part.agents = connection.endpoint.label;
    part.endpoint = connection.endpoint.text;
    part.cpu_seconds = cpu_seconds(connection);

    proxy::LatencySamples samples;
    const auto add = [&](int number, const proxy::AgentStatistics& statistics) {
      const std::vector<int>& agents = connection.endpoint.agents;
      if (std::ranges::find(agents, number) == agents.end()) return;
      part.decisions += statistics.decisions;
      part.late += statistics.late;
      part.missed += statistics.missed;
      samples.add(statistics.rpc_us);
    };

    for (const auto& agent : team_->players()) add(agent->unum(), agent->statistics());
    if (team_->coach() != nullptr) add(team_->coach()->number(), team_->coach()->statistics());
    part.rpc_us = latency_of(samples);
    result.parts.push_back(std::move(part));
  }
}

TeamResult AgentSide::result() const {
  TeamResult result;
  result.name = identity().name;
  result.endpoint = identity().endpoint;
  result.cpu_seconds = worker_.cpu_seconds();
  for (const PlaymakerConnection* connection : connections()) {
    result.cpu_seconds += cpu_seconds(*connection);
  }

  for (const auto& agent : team_->players()) {
    result.players.push_back(match::result_of(agent->unum(), agent->statistics()));
  }
  if (const proxy::CoachAgent* coach = team_->coach()) {
    result.coach = match::result_of(coach->number(), coach->statistics());
    result.coach->commands = coach->commands();
    result.coach->actions = outcomes_by_name(coach->report(), coach->is_trainer());
  }

  const proxy::PlaymakerErrors& errors = team_->errors();
  result.errors.count = errors.count;
  if (errors.first) {
    const proxy::PlaymakerError& first = *errors.first;
    result.errors.first = {
        std::string(name(first.rpc)), first.status, first.message, first.cycle, first.agent, {}};
  }

  add_parts(result);
  return result;
}

}  // namespace cls::match
