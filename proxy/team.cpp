// Cycles of a team.
#include "proxy/team.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "proxy/parameter_messages.h"

namespace cls::proxy {
namespace {

constexpr RpcTimeout kByeTimeout{1000};
// In real time: for the way to the server, and the least that a Playmaker is given.
constexpr RpcTimeout kReserve{10};
constexpr RpcTimeout kShortestTimeout{10};

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

// Calls that inform a Playmaker may fail without harm, as long as it is there and speaks at all.
bool harmless(const RpcStatus& status) {
  return status.outcome == RpcOutcome::kUnimplemented || status.outcome == RpcOutcome::kError;
}

protos::RegisterRequest register_request(const PlayerAgent& agent) {
  protos::RegisterRequest request;
  request.set_agent_type(protos::PlayerT);
  request.set_team_name(std::string(agent.options().team_name.view()));
  request.set_uniform_number(agent.unum());
  return request;
}

// For Playmakers of the first interface, which do not hand out identities.
protos::RegisterResponse own_identity(const protos::RegisterRequest& request) {
  protos::RegisterResponse identity;
  identity.set_agent_type(request.agent_type());
  identity.set_team_name(request.team_name());
  identity.set_uniform_number(request.uniform_number());
  return identity;
}

}  // namespace

Team::Team(TeamOptions options, Playmaker& playmaker)
    : options_(std::move(options)), name_(options_.name.view()), playmaker_(&playmaker) {}

soccer::Result<void> Team::connect(const OpenChannel& open, const Serve& serve) {
  for (int i = 0; i < options_.players; ++i) {
    const bool goalie = options_.goalie && i == 0;
    if (const soccer::Result<void> done = connect_one(open, serve, goalie); !done) return done;
  }
  return {};
}

soccer::Result<void> Team::connect_one(const OpenChannel& open, const Serve& serve, bool goalie) {
  const std::string who = name_ + ", player " + std::to_string(players_.size() + 1) + ": ";
  std::unique_ptr<soccer::Channel> channel = open();
  if (channel == nullptr) return soccer::Error{who + "no connection to the soccer server"};
  AgentOptions options;
  options.team_name = options_.name;
  options.goalie = goalie;
  options.protocol = options_.protocol;
  options.on_late = options_.on_late;
  options.formations = options_.formations;
  options.debug_log = options_.debug_log;
  if (options_.reconnect) {
    options.reconnect_unum = options_.first_unum + static_cast<int>(players_.size());
  }
  auto agent = std::make_unique<PlayerAgent>(std::move(channel), options);
  if (!agent->connect()) return soccer::Error{who + "the soccer server closed the connection"};
  while (!agent->ready()) {
    const bool go_on = serve();
    agent->perceive();
    if (agent->refused_for_now() && go_on) {
      agent->connect();
    } else if (!agent->refusal().empty()) {
      return soccer::Error{who + "the soccer server refused it (" + agent->refusal() + ")"};
    }
    if (!go_on && !agent->ready()) {
      return soccer::Error{who + "the soccer server did not answer"};
    }
  }
  players_.push_back(std::move(agent));
  return {};
}

RpcStatus Team::introduce() {
  for (const auto& agent : players_) {
    RpcStatus status = introduce_one(*agent);
    if (!status.ok()) {
      status.message = "player " + std::to_string(agent->unum()) + ": " + status.message;
      return status;
    }
  }
  return {};
}

RpcStatus Team::introduce_one(PlayerAgent& agent) {
  const protos::RegisterRequest request = register_request(agent);
  protos::RegisterResponse identity;
  const RpcStatus status =
      playmaker_->register_agent(agent.unum(), request, options_.start_timeout, identity);
  if (status.outcome == RpcOutcome::kUnimplemented) {
    identity = own_identity(request);
    warn_once("the Playmaker has no Register: taken for one of the first interface");
  } else if (!status.ok()) {
    return status;
  }
  agent.set_identity(identity);
  return send_parameters(agent);
}

RpcStatus Team::send_parameters(PlayerAgent& agent) {
  const int unum = agent.unum();
  const MatchParameters& parameters = *agent.world().parameters;
  const auto introduced = [&](auto message) {
    *message.mutable_register_response() = agent.identity();
    return message;
  };
  const auto tolerated = [&](RpcStatus& status) {
    if (harmless(status)) {
      warn_once(status.message);
      status = {};
    }
    return status.ok();
  };
  protos::ServerParam server;
  protos::PlayerParam player;
  fill(parameters.server, server);
  fill(parameters.player, player);
  RpcStatus status =
      playmaker_->send_server_params(unum, introduced(server), options_.start_timeout);
  if (!tolerated(status)) return status;
  status = playmaker_->send_player_params(unum, introduced(player), options_.start_timeout);
  if (!tolerated(status)) return status;
  for (const soccer::PlayerType& each : parameters.types) {
    protos::PlayerType type;
    fill(each, parameters.server, type);
    status = playmaker_->send_player_type(unum, introduced(type), options_.start_timeout);
    if (!tolerated(status)) return status;
  }
  status = playmaker_->send_init_message(unum, introduced(protos::InitMessage()),
                                         options_.start_timeout);
  tolerated(status);
  return status;
}

PlayerAgent& Team::agent(int unum) {
  const auto found = std::find_if(players_.begin(), players_.end(),
                                  [unum](const auto& agent) { return agent->unum() == unum; });
  assert(found != players_.end());
  return **found;
}

int Team::begin_cycle() { return ask({}); }

int Team::ask(Instant now) {
  int asked = 0;
  StopWatch watch;
  for (const auto& agent : players_) {
    agent->perceive();
    watch.lap(times_.perceive);
    if (!agent->decision_due(now)) continue;
    const protos::State& state = agent->state(now);
    watch.lap(times_.state);
    playmaker_->begin_player_actions(agent->unum(), state, decision_timeout(*agent, now));
    watch.lap(times_.begin);
    ++asked;
  }
  outstanding_ += asked;
  return asked;
}

void Team::finish_cycle() {
  StopWatch watch;
  while (const std::optional<Reply> reply = playmaker_->next_reply()) {
    watch.lap(times_.wait);
    carry_out(*reply);
    watch.lap(times_.act);
  }
}

bool Team::take_reply(std::chrono::microseconds longest) {
  StopWatch watch;
  const std::optional<Reply> reply = playmaker_->next_reply_within(longest);
  watch.lap(times_.wait);
  if (!reply) return false;
  carry_out(*reply);
  watch.lap(times_.act);
  return true;
}

Instant Team::next_due() const {
  Instant next = Instant::max();
  for (const auto& agent : players_) {
    if (!agent->deciding()) next = std::min(next, agent->timer().due_at());
  }
  return next;
}

// In real time, an answer after the end of the cycle would be of no use.
RpcTimeout Team::decision_timeout(const PlayerAgent& agent, Instant now) const {
  const bool unlimited = options_.decision_timeout == kNoTimeout;
  if (agent.timer().synchronous() || unlimited) return options_.decision_timeout;
  const soccer::ServerParams& server = agent.world().server();
  const RpcTimeout cycle(server.simulator_step * server.slow_down_factor);
  const auto gone = std::chrono::duration_cast<RpcTimeout>(now - agent.timer().cycle_began());
  return std::min(options_.decision_timeout, std::max(kShortestTimeout, cycle - kReserve - gone));
}

int Team::run_cycle() {
  const int asked = begin_cycle();
  finish_cycle();
  return asked;
}

void Team::carry_out(const Reply& reply) {
  --outstanding_;
  PlayerAgent& asker = agent(reply.agent);
  if (asker.awaits_choice()) {
    carry_out_choice(asker, reply);
    return;
  }
  asker.statistics().count(reply);
  if (reply.player == nullptr) {
    asker.act_without_reply();
  } else if (!asker.act(*reply.player)) {
    ask_for_choice(asker);
    return;
  }
  warn_of_unimplemented(asker);
  warn_of_server(asker);
}

void Team::ask_for_choice(PlayerAgent& asker) {
  ++asker.statistics().planner_asked;
  const RpcTimeout timeout = decision_timeout(asker, std::chrono::steady_clock::now());
  playmaker_->begin_best_planner_action(asker.unum(), asker.planner_request(), timeout);
  ++outstanding_;
}

void Team::carry_out_choice(PlayerAgent& asker, const Reply& reply) {
  if (reply.planner != nullptr) {
    asker.act_on_choice(reply.planner->index());
  } else {
    ++asker.statistics().planner_failed;
    warn_once("the Playmaker did not choose a planned action: " + reply.status.message);
    asker.act_on_choice(std::nullopt);
  }
  warn_of_unimplemented(asker);
  warn_of_server(asker);
}

void Team::leave() {
  bool reacts = true;
  for (const auto& agent : players_) {
    if (reacts && agent->has_identity()) {
      const RpcStatus status = playmaker_->send_bye(agent->unum(), agent->identity(), kByeTimeout);
      reacts = status.ok() || harmless(status);
    }
    agent->leave();
  }
}

soccer::Side Team::side() const {
  return players_.empty() ? soccer::Side::kNeutral : players_.front()->world().our_side;
}

MissingAnswers Team::missing_answers() const {
  MissingAnswers worst;
  for (const auto& agent : players_) {
    const AgentStatistics& statistics = agent->statistics();
    if (statistics.missed_in_a_row <= worst.in_a_row) continue;
    worst = {agent->unum(), statistics.missed_in_a_row, statistics.last_failure};
  }
  return worst;
}

void Team::warn_once(const std::string& line) {
  if (std::find(warnings_.begin(), warnings_.end(), line) == warnings_.end()) {
    warnings_.push_back(line);
  }
}

void Team::warn_of_unimplemented(const PlayerAgent& agent) {
  const ActionReport& report = agent.statistics().actions;
  const auto warn = [&](const auto& counts, auto& told, const char* verb, auto name_of) {
    for (std::size_t kind = 0; kind < told.size(); ++kind) {
      if (counts[kind].unimplemented == 0 || std::exchange(told[kind], true)) continue;
      warn_once(std::string("the Playmaker ") + verb + " " +
                std::string(name_of(static_cast<int>(kind))) +
                ", which this proxy does not have: skipped");
    }
  };
  warn(report.actions, told_actions_, "asks for", action_name);
  warn(report.say, told_say_, "says", say_name);
}

void Team::warn_of_server(const PlayerAgent& agent) {
  const ServerTrouble& trouble = agent.server_trouble();
  if (trouble.unreadable != 0) {
    warn_once("a message of the soccer server is not understood: " + trouble.first_unreadable);
  }
  if (trouble.errors != 0) {
    warn_once("the soccer server complains: " + trouble.first_error);
  }
  if (trouble.warnings != 0) {
    warn_once("the soccer server warns: " + trouble.first_warning);
  }
}

std::vector<std::string> Team::take_warnings() {
  const auto first = warnings_.begin() + static_cast<std::ptrdiff_t>(warnings_taken_);
  std::vector<std::string> fresh(first, warnings_.end());
  warnings_taken_ = warnings_.size();
  return fresh;
}

}  // namespace cls::proxy
