// Setting up a cls team, and reading off what it did.
#include "orchestration/match/sides/agent_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "proxy/playmaker/direct_playmaker.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::orchestration::match {
namespace {

using base::Result;

// Calls to a crashed process fail before its exit is known.
constexpr std::chrono::milliseconds kProgramExitDelay{500};

proxy::RpcTimeout to_timeout(double seconds) {
  return std::chrono::duration_cast<proxy::RpcTimeout>(std::chrono::duration<double>(seconds));
}

std::map<std::string, std::int64_t> missed_by(const proxy::AgentStatistics& statistics) {
  std::map<std::string, std::int64_t> by_outcome;
  for (int i = 1; i < proxy::kRpcOutcomes; ++i) {
    const std::int64_t n = statistics.outcomes[static_cast<std::size_t>(i)];
    const auto outcome = static_cast<proxy::RpcOutcome>(i);
    if (n != 0 && outcome != proxy::RpcOutcome::kCancelled) by_outcome.emplace(name(outcome), n);
  }
  return by_outcome;
}

/// Starts the mock and connects to it. Without faults no reply is late or fails, so `auto` calls
/// the mock as a function; other modes of --batch ask for a way of gRPC.
Result<void> connect_mock(const Endpoint& endpoint, const SideSetup& setup,
                          PlaymakerConnection& out) {
  auto started = start_mock(endpoint);
  if (!started) return started.error();
  out.mock = std::move(*started);
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

}  // namespace

proxy::TeamOptions team_options(const SideSetup& setup, const Endpoint& endpoint,
                                const MatchOptions& options) {
  proxy::TeamOptions team;
  team.name = soccer::TeamName(setup.name);
  if (setup.side == soccer::Side::kNeutral) team.players = 0;
  team.formations =
      setup.side == soccer::Side::kRight ? options.right_formations : options.left_formations;
  team.protocol = options.protocol;
  team.on_late = options.on_late;
  team.decision_timeout = reply_timeout(options).value_or(proxy::kNoTimeout);
  team.start_timeout = to_timeout(options.start_timeout_s) + kMatchLimitMargin;
  team.reconnect_within = to_timeout(options.reconnect_within_s);
  team.shared_playmaker = !endpoint.port_step;
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
  result.rpc_us.p50 = statistics.rpc_us.percentile(0.50);
  result.rpc_us.p95 = statistics.rpc_us.percentile(0.95);
  result.rpc_us.p99 = statistics.rpc_us.percentile(0.99);
  result.rpc_us.max = statistics.rpc_us.max();
  result.commands = statistics.commands_by_name();
  result.unimplemented_actions = statistics.unimplemented_by_name();
  result.actions = outcomes_by_name(statistics.actions);
  result.automatic = automatic_by_name(statistics.actions);
  result.lists = statistics.actions.lists;
  result.empty = statistics.actions.empty;
  result.useless = statistics.actions.useless;
  result.missed_by = missed_by(statistics);
  result.reconnects = statistics.reconnects;
  return result;
}

Result<PlaymakerConnection> connect_playmaker(const Endpoint& endpoint, const SideSetup& setup) {
  PlaymakerConnection connection;
  connection.endpoint = endpoint;
  const proxy::RpcTimeout team_reply =
      setup.batch == proxy::BatchMode::kAuto ? proxy::kTeamReplyTimeout : proxy::kNoTimeout;
  if (endpoint.kind == Endpoint::Kind::kMock) {
    if (auto connected = connect_mock(endpoint, setup, connection); !connected) {
      return connected.error();
    }
  } else if (endpoint.kind == Endpoint::Kind::kRun) {
    auto started = PlaymakerProcess::start(
        *setup.host, endpoint, {0, setup.side, setup.name, setup.seed}, setup.folder, setup.cpus);
    if (!started) return started.error();
    connection.process = std::move(*started);
    proxy::GrpcTarget target;
    target.host = "localhost";
    target.port = connection.process->port();
    connection.playmaker = proxy::make_grpc_playmaker(target, team_reply);
  } else {
    connection.playmaker = proxy::make_grpc_playmaker(target_of(endpoint), team_reply);
  }
  if (!endpoint.port_step && !connection.direct) {
    connection.playmaker =
        proxy::make_batch_playmaker(std::move(connection.playmaker), setup.batch);
  }
  return connection;
}

AgentSide::AgentSide(SideIdentity identity, PlaymakerConnection connection, proxy::TeamOptions team,
                     const MatchOptions& options, const std::vector<int>& cpus)
    : MatchSide(std::move(identity)), connection_(std::move(connection)), options_(options) {
  worker_.set_affinity(cpus);
  watched_ = proxy::watch_calls(*connection_.playmaker, watch_);
  team_ = std::make_unique<proxy::Team>(std::move(team), *watched_);
}

bool AgentSide::listen(SideListener& listener) {
  proxy::Playmaker& inner = listened_.empty() ? *watched_ : *listened_.back();
  listened_.push_back(proxy::listen_to(inner, listener));
  listeners_.push_back(&listener);
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
  return MatchEnd{garbled ? EndReason::kProtocolError : EndReason::kRefused,
                  fmt::format("{}: {}", who(), status.message),
                  {},
                  {},
                  false};
}

std::string AgentSide::timeout_hint() const {
  return playmaker_process() != nullptr ? playmaker_process()->port_hint()
                                        : unreachable_hint(connection_.endpoint);
}

const process::Child* AgentSide::awaited_process() const {
  return playmaker_process() == nullptr ? nullptr : &playmaker_process()->child();
}

std::optional<MatchEnd> AgentSide::failure(const MatchMoment& moment) {
  auto end = agent_failure(moment);
  const PlaymakerProcess* started = playmaker_process();
  if (started == nullptr) {
    if (end) end->failure = playmaker_failure(identity().side);
    return end;
  }
  if (end) started->child().wait_exit(kProgramExitDelay);
  if (started->ended()) {
    MatchEnd crash;
    crash.failure = failure_of(started->child());
    crash.reason = moment.playing ? EndReason::kCrashed : EndReason::kRefused;
    crash.message = fmt::format(
        "{}: its process ended {}: {}", who(),
        moment.playing ? fmt::format("at cycle {}", moment.cycle) : "before it answered",
        crash.failure->exit);
    return crash;
  }
  if (end) end->failure = failure_of(started->child());
  return end;
}

std::vector<ProcessResult> AgentSide::wait_gone() {
  if (playmaker_process() == nullptr) return {};
  playmaker_process()->child().wait_gone(kTerminateGrace + kKillMargin);
  return {match::result_of(playmaker_process()->child())};
}

std::vector<std::string> AgentSide::failed_expectations() const {
  return connection_.mock == nullptr ? std::vector<std::string>()
                                     : connection_.mock->failed_expectations();
}

// In a turn the agents compute, or wait for replies.
TurnTimes AgentSide::turn_times() const {
  const proxy::TeamTimes& times = team_->times();
  const auto work = times.perceive + times.state + times.begin + times.act;
  return {times.turns, std::max(std::chrono::nanoseconds(0), times.turns - work)};
}

double AgentSide::mock_cpu_seconds() const {
  constexpr double kNanosecond = 1e-9;
  if (connection_.mock == nullptr) return 0.0;
  return static_cast<double>(connection_.mock->decision_nanoseconds()) * kNanosecond;
}

TeamResult AgentSide::result() const {
  TeamResult result;
  result.name = identity().name;
  result.endpoint = identity().endpoint;
  result.cpu_seconds = worker_.cpu_seconds();
  if (!connection_.direct) result.cpu_seconds += mock_cpu_seconds();
  if (playmaker_process() != nullptr) {
    result.cpu_seconds += playmaker_process()->child().cpu_seconds();
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
  return result;
}

}  // namespace cls::orchestration::match
