// Cycles of a team.
#include "proxy/agent/team.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <tuple>
#include <utility>

#include "base/index.h"
#include "proto/status_name.h"

namespace cls::proxy {
namespace {

constexpr RpcTimeout kByeTimeout{1000};
// In real time: reserve for the way to the server, and the minimum timeout.
constexpr RpcTimeout kReserve{10};
constexpr RpcTimeout kMinTimeout{10};

/// Adds the time since the last lap to a sum.
class StopWatch {
 public:
  void lap(std::chrono::nanoseconds& sum) {
    const auto now = std::chrono::steady_clock::now();
    sum += now - last_;
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Playmakers of the first interface assign no client_id.
constexpr int kNoClientId = 0;

bool responds_to_bye(const RpcStatus& status) {
  return status.ok() || status.outcome == RpcOutcome::kUnimplemented ||
         status.outcome == RpcOutcome::kError;
}

protos::RegisterRequest register_request(const PlayerAgent& agent) {
  protos::RegisterRequest request;
  request.set_agent_type(protos::PlayerT);
  request.set_team_name(std::string(agent.options().team_name.view()));
  request.set_uniform_number(agent.unum());
  return request;
}

}  // namespace

Team::Team(TeamOptions options, Playmaker& playmaker)
    : options_(std::move(options)), name_(options_.name.view()), playmaker_(&playmaker) {}

base::Result<void> Team::connect(const OpenChannel& open, const Serve& serve) {
  for (int i = 0; i < options_.players; ++i) {
    TRY(connect_one(open, serve, options_.goalie && i == 0));
  }
  return {};
}

base::Result<void> Team::connect_one(const OpenChannel& open, const Serve& serve, bool goalie) {
  const std::string who = name_ + ", player " + std::to_string(players_.size() + 1) + ": ";
  std::unique_ptr<soccer::Channel> channel = open();
  if (channel == nullptr) return base::Error{who + "no connection to the soccer server"};

  const PlayerOptions& shared = options_;
  AgentOptions options{shared, options_.name, goalie};
  if (options_.reconnect) {
    options.reconnect_unum = options_.first_unum + static_cast<int>(players_.size());
  }

  auto agent = std::make_unique<PlayerAgent>(std::move(channel), options);
  if (const base::Result<void> entered = connect_agent(*agent, serve); !entered) {
    return base::Error{who + entered.error().message};
  }
  if (find_player(agent->unum()) != nullptr) {
    return base::Error{who + "the soccer server gave it number " + std::to_string(agent->unum()) +
                       ", which another player has"};
  }
  players_.push_back(std::move(agent));
  return {};
}

TeamRegistration Team::registration() const {
  TeamRegistration team;
  for (const auto& agent : players_) {
    team.agents.emplace_back(agent->unum(), register_request(*agent));
  }

  if (coach_ != nullptr) team.agents.emplace_back(coach_->number(), coach_registration());
  if (!team.agents.empty()) team.parameters = world().parameters;
  team.codec = options_.codec;
  team.world_of = [this](int unum) -> const player::WorldModel& {
    return player(unum).decision_world();
  };
  team.rated = options_.rated;
  return team;
}

RpcStatus Team::register_agents() {
  playmaker_->announce_team(registration());
  for (const auto& agent : players_) {
    const RpcStatus status =
        register_agent(*agent, agent->unum(), proto::Rpc::kGetPlayerActions,
                       register_request(*agent), "player " + std::to_string(agent->unum()));
    if (!status.ok()) return status;
  }
  warn_of_shared_identity();
  return coach_ == nullptr ? RpcStatus{} : register_coach();
}

RpcStatus Team::register_agent(Agent& agent, int number, proto::Rpc decision,
                               protos::RegisterRequest request, const std::string& who) {
  PlaymakerClient& client =
      clients_.at(base::index(number))
          .emplace(number, decision, std::move(request), agent.world().parameters);
  RpcStatus status =
      client.register_agent(*playmaker_, options_.start_timeout, agent.mutable_state());
  warn_once(client.take_warning());
  if (!status.ok()) status.message = who + ": " + status.message;
  return status;
}

void Team::warn_of_shared_identity() {
  if (!options_.shared_playmaker) return;
  std::map<int, int> holders;  // unum by client id
  for (const auto& agent : players_) {
    const int id = agent->identity().client_id();
    const auto [holder, fresh] = holders.emplace(id, agent->unum());
    if (fresh || id == kNoClientId) continue;
    warn_once("the Playmaker assigned players " + std::to_string(holder->second) + " and " +
              std::to_string(agent->unum()) + " the same client_id " + std::to_string(id));
    return;
  }
}

PlaymakerClient& Team::client_of(int number) {
  std::optional<PlaymakerClient>& client = clients_.at(base::index(number));
  assert(client && "register_agents() comes before decisions");
  return *client;
}

PlayerAgent* Team::find_player(int unum) const {
  const auto found = std::ranges::find(players_, unum, &PlayerAgent::unum);
  return found != players_.end() ? found->get() : nullptr;
}

PlayerAgent& Team::player(int unum) const {
  PlayerAgent* const found = find_player(unum);
  assert(found != nullptr);
  return *found;
}

int Team::begin_cycle() { return begin_decisions({}); }

int Team::begin_decisions(Instant now) {
  int begun = 0;
  if (outstanding_ == 0) turn_began_ = Instant::clock::now();
  StopWatch watch;
  for (const auto& agent : players_) {
    agent->perceive();
    watch.lap(times_.perceive);
    if (!agent->decision_due(now)) continue;

    agent->state(now);
    watch.lap(times_.state);
    for (DecisionListener* listener : decision_listeners_) listener->before_decision(*agent);
    request_decision(*agent, agent->unum(), decision_timeout(*agent, now),
                     agent->timer().synchronous());
    watch.lap(times_.begin);
    ++begun;
  }

  begun += begin_coach_decision(now);
  playmaker_->send();
  outstanding_ += begun;
  return begun;
}

void Team::finish_cycle() {
  StopWatch watch;
  while (const std::optional<Reply> reply = playmaker_->next_reply()) {
    watch.lap(times_.wait);
    execute(*reply);
    watch.lap(times_.act);
  }
  end_turn();
}

void Team::end_turn() {
  if (outstanding_ > 0) return;
  const auto time = Instant::clock::now() - turn_began_;
  times_.turns += time;
  times_.turn_us.add(std::chrono::duration_cast<std::chrono::microseconds>(time));
}

bool Team::begins_turn(Instant now) {
  for (const auto& agent : players_) agent->perceive();
  // A (think) that has just been received is due later than `now`.
  const Instant perceived = std::max(now, Instant::clock::now());
  std::int64_t turn = 0;
  for (const auto& agent : players_) {
    if (agent->decision_due(perceived)) turn = std::max(turn, agent->statistics().decisions + 1);
  }
  const bool begins = turn > turn_;
  turn_ = std::max(turn_, turn);
  return begins;
}

bool Team::handle_reply(std::chrono::microseconds timeout) {
  StopWatch watch;
  const std::optional<Reply> reply = playmaker_->next_reply_within(timeout);
  watch.lap(times_.wait);
  if (!reply) return false;
  execute(*reply);
  watch.lap(times_.act);
  end_turn();
  return true;
}

Instant Team::heard_at() const {
  if (players_.empty() && coach_ != nullptr) return coach_->server().channel->received_at();
  Instant latest;
  for (const auto& agent : players_) {
    latest = std::max(latest, agent->server().channel->received_at());
  }
  return latest;
}

Instant Team::next_due() const {
  Instant next = Instant::max();
  for (const auto& agent : players_) {
    if (!agent->deciding()) next = std::min(next, agent->timer().due_at());
  }
  return next;
}

void Team::request_decision(Agent& agent, int number, RpcTimeout timeout, bool server_waits) {
  client_of(number).request_decision(*playmaker_, agent.mutable_state(),
                                     {timeout, server_waits, options_.reconnect_within});
}

// In real time, a reply after the end of the cycle is useless.
RpcTimeout Team::decision_timeout(const PlayerAgent& agent, Instant now) const {
  const bool unlimited = options_.decision_timeout == kNoTimeout;
  if (agent.timer().synchronous() || unlimited) return options_.decision_timeout;

  const soccer::ServerParams& server = agent.world().server();
  const RpcTimeout cycle(server.simulator_step * server.slow_down_factor);
  const auto elapsed = std::chrono::duration_cast<RpcTimeout>(now - agent.timer().cycle_began());
  return std::min(options_.decision_timeout, std::max(kMinTimeout, cycle - kReserve - elapsed));
}

int Team::run_cycle() {
  const int begun = begin_cycle();
  finish_cycle();
  return begun;
}

void Team::execute(Reply reply) {
  if (reply.agent >= kCoachNumber) {
    if (decides(reply)) handle_coach_reply(reply);
    return;
  }

  PlayerAgent& agent = player(reply.agent);
  if (agent.awaits_planner_choice()) {
    --outstanding_;
    handle_planner_reply(agent, reply);
    return;
  }
  if (!decides(reply)) return;

  count_reply(agent, reply);
  const auto* actions = reply.as<protos::PlayerActions>();
  if (actions == nullptr) {
    agent.act_without_reply();
  } else if (!agent.act(*actions)) {
    request_planner_choice(agent, reply);
    return;
  }
  report_decision(agent, agent.has_own_play() ? nullptr : actions, reply.status, reply.latency);
  warn_of_actions(agent);
  warn_of_server(agent.server().errors);
}

bool Team::decides(Reply& reply) {
  PlaymakerClient& client = client_of(reply.agent);
  const bool decided = client.handle_reply(*playmaker_, reply);
  warn_once(client.take_warning());
  if (decided) --outstanding_;
  return decided;
}

void Team::count_reply(PlayerAgent& agent, const Reply& reply) {
  AgentStatistics& statistics = agent.statistics();
  statistics.count(reply);
  count_error(reply, agent, agent.mutable_state());

  const int reconnects = client_of(reply.agent).reconnects();
  if (reconnects == statistics.reconnects) return;
  statistics.reconnects = reconnects;
  const int errors = client_of(reply.agent).errors_before_reconnect();
  const std::string why = errors == 0 ? "connection to the Playmaker lost"
                                      : std::to_string(errors) + " errors of a player in a row";
  warn_once(why + "; players registered again at cycle " +
            std::to_string(agent.world().game.time.cycle));
}

// Replies arrive in any order: of the errors in a cycle, the one of the lowest agent is the first.
void Team::count_error(const Reply& reply, const Agent& agent,
                       const google::protobuf::Message& request) {
  if (!is_error(reply.status)) return;
  ++errors_.count;
  const int cycle = agent.world().game.time.cycle;
  const std::optional<PlaymakerError>& first = errors_.first;
  if (first && (warned_of_error_ || first->cycle != cycle || first->agent <= reply.agent)) return;

  PlaymakerError error = describe_error(reply, cycle);
  // A re-registration that fails has no decision to repeat.
  if (is_decision(reply.rpc) || reply.rpc == proto::Rpc::kGetBestPlannerAction) {
    error.calls = client_of(reply.agent).recorded_handshake(agent.identity());
    recording::RecordedCall call = record_call(reply.agent, reply.rpc, 1, request);
    // A reply that does not parse has no gRPC status of its own.
    call.set_status(reply.status.code != 0 ? reply.status.code : proto::kStatusUnknown);
    call.set_message(reply.status.message);
    error.calls.push_back(std::move(call));
  }
  errors_.first = std::move(error);
}

void Team::report_decision(const PlayerAgent& agent, const protos::PlayerActions* actions,
                           const RpcStatus& status, std::chrono::microseconds latency) const {
  for (DecisionListener* listener : decision_listeners_) {
    listener->on_decision({agent, actions, status, latency});
  }
}

void Team::request_planner_choice(PlayerAgent& agent, const Reply& reply) {
  ++agent.statistics().planner_asked;
  first_latency_.at(base::index(agent.unum())) = reply.latency;
  const RpcTimeout timeout = decision_timeout(agent, std::chrono::steady_clock::now());
  playmaker_->begin(agent.unum(), proto::Rpc::kGetBestPlannerAction, agent.planner_request(),
                    timeout);
  ++outstanding_;
}

void Team::handle_planner_reply(PlayerAgent& agent, const Reply& reply) {
  if (const auto* choice = reply.as<protos::BestPlannerActionResponse>()) {
    agent.act_on_planner_choice(choice->index());
  } else {
    ++agent.statistics().planner_failed;
    count_error(reply, agent, agent.planner_request());
    if (!is_error(reply.status)) {
      warn_once("the Playmaker chose no planned action: " + reply.status.message);
    }
    agent.act_on_planner_choice(std::nullopt);
  }

  // A choice that failed is not a missed decision: the list was received.
  report_decision(agent, &agent.chosen_from(), RpcStatus{},
                  first_latency_.at(base::index(agent.unum())) + reply.latency);
  warn_of_actions(agent);
  warn_of_server(agent.server().errors);
}

RpcStatus Team::send_bye(int number, const Agent& agent) {
  return playmaker_->call(number, proto::Rpc::kSendByeCommand, agent.identity(), kByeTimeout)
      .status;
}

void Team::leave() {
  bool responds = true;
  for (const auto& agent : players_) {
    if (responds && agent->has_identity()) {
      responds = responds_to_bye(send_bye(agent->unum(), *agent));
    }
    agent->leave();
  }
  if (coach_ == nullptr) return;
  if (responds && coach_->has_identity()) send_bye(coach_->number(), *coach_);
  coach_->leave();
}

soccer::Side Team::side() const {
  const bool trains = coach_ != nullptr && coach_->is_trainer();
  if (players_.empty() && (coach_ == nullptr || trains)) return soccer::Side::kNeutral;
  return world().our_side;
}

MissedDecisions Team::missed_decisions() const {
  MissedDecisions worst;
  for (const auto& agent : players_) {
    const AgentStatistics& statistics = agent->statistics();
    if (statistics.consecutive_missed <= worst.consecutive) continue;
    worst = {agent->unum(), statistics.consecutive_missed, statistics.last_failure};
  }
  if (coach_ == nullptr) return worst;

  // The team continues with a coach whose calls fail; a coach without replies delays the match.
  const AgentStatistics& statistics = coach_->statistics();
  const bool fails = statistics.last_failure.outcome == RpcOutcome::kError;
  if (statistics.consecutive_missed > worst.consecutive && (coach_->is_trainer() || !fails)) {
    worst = {coach_->number(), statistics.consecutive_missed, statistics.last_failure};
  }
  return worst;
}

void Team::warn_once(const std::string& line) {
  if (line.empty() || std::ranges::find(warnings_, line) != warnings_.end()) return;
  warnings_.push_back(line);
}

void Team::warn_of_actions(const PlayerAgent& agent) {
  const player::ActionReport& report = agent.statistics().actions;
  const auto warn = [&](const auto& counts, auto& warned, const char* verb, auto name_of) {
    const auto warn_of = [&](std::size_t kind, const char* consequence) {
      warn_once(std::string("the Playmaker ") + verb + " " +
                std::string(name_of(static_cast<int>(kind))) + consequence);
    };

    for (std::size_t kind = 0; kind < warned.size(); ++kind) {
      ActionWarnings& given = warned[kind];
      if (counts[kind].unimplemented != 0 && !std::exchange(given.unimplemented, true)) {
        warn_of(kind, ", unknown to this proxy: skipped");
      }
      if (counts[kind].invalid != 0 && !std::exchange(given.invalid, true)) {
        warn_of(kind, " with a number that is not finite (NaN or infinity): ignored");
      }
    }
  };

  warn(report.actions, warned_actions_, "sends action", action_name);
  warn(report.say, warned_say_, "sends say message", say_name);
}

void Team::warn_of_server(const ServerErrors& errors) {
  for (const auto& [count, kind, first] :
       {std::tuple{errors.unreadable, "unreadable message", &errors.first_unreadable},
        {errors.errors, "error", &errors.first_error},
        {errors.warnings, "warning", &errors.first_warning}}) {
    if (count != 0) warn_once(std::string(kind) + " of the soccer server: " + *first);
  }
}

std::vector<std::string> Team::take_warnings() {
  warn_once(playmaker_->take_warning());
  if (errors_.first && !std::exchange(warned_of_error_, true)) {
    warn_once(errors_.first->describe());
  }
  const auto first = warnings_.begin() + static_cast<std::ptrdiff_t>(warnings_taken_);
  std::vector<std::string> fresh(first, warnings_.end());
  warnings_taken_ = warnings_.size();
  return fresh;
}

}  // namespace cls::proxy
